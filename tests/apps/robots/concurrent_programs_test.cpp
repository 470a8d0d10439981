// Programs that are called from files of their own next to the main one.

#include "base/text/json.h"
#include "tests/apps/run_program.h"

namespace gsim::apps::programs_beside_test {
namespace {

using nlohmann::json;

class CalledProgramFiles : public Apps {
  protected:
    json report(const std::string& name) {
        const Ended e = gsim_run({name, "--json"});
        json r = text::try_parse_json<json>(e.out);
        EXPECT_FALSE(r.is_discarded()) << e.err;
        return r;
    }
    double reached(const std::string& name) {
        const json r = report(name);
        EXPECT_EQ(r["status"], "completed") << r["alarm"];
        return r["bounds"]["X"]["max"];
    }
    const std::string main_ = write("wheel.nc", "O1\nM98 P2\nM2\n");
};

TEST_F(CalledProgramFiles, AreFoundByNumber) {
    for (const char* name : {"O0002", "O2", "O0002.NC", "O0002.nc", "O2.nc", "O0002.ngc", "O0002.tap",
                             "wheel_O0002.ppg", "wheel_O0002.nc"}) {
        SCOPED_TRACE(name);
        write(name, "O2\nG0 X20\nM99\n");
        EXPECT_DOUBLE_EQ(reached(main_), 20);
        std::filesystem::remove(folder_ / name);
    }
}

TEST_F(CalledProgramFiles, MayOmitProgramNumber) {
    write("O0002.nc", "G0 X20\n");
    EXPECT_DOUBLE_EQ(reached(main_), 20);
}

TEST_F(CalledProgramFiles, MayBeScripts) {
    write("O0002.lua", "program(2, function() G0{x=30.0} end)\n");
    EXPECT_DOUBLE_EQ(reached(main_), 30);
    write("O0002.lua", gcode2lua({write("two.nc", "O2\nG0 X40\nM99\n")}).out);
    EXPECT_DOUBLE_EQ(reached(main_), 40);
}

TEST_F(CalledProgramFiles, AreFoundForNumberedMainProgram) {
    write("part_O0001.ppg", "O1\nM98 P3\nM2\n");
    write("part_O0003.ppg", "O3\nG0 X50\nM99\n");
    EXPECT_DOUBLE_EQ(reached("part_O0001.ppg"), 50);
}

TEST_F(CalledProgramFiles, AreFoundInFolderOfMainProgram) {
    write("sub/main.nc", "O1\nM98 P2\nM2\n");
    write("sub/O0002.nc", "O2\nG0 X60\nM99\n");
    write("O0002.nc", "O2\nG0 X70\nM99\n");
    EXPECT_DOUBLE_EQ(reached("sub/main.nc"), 60);
}

TEST_F(CalledProgramFiles, MayCallOtherFiles) {
    write("O0002.nc", "O2\nM98 P3 L2\nM99\n");
    write("O0003.nc", "O3\nG91 G0 X5\nG90\nM99\n");
    EXPECT_DOUBLE_EQ(reached(main_), 10);
}

TEST_F(CalledProgramFiles, AlarmsNameTheirFile) {
    write("O0002.nc", "O2\n\nG0 X-1\nM99\n");
    const json r = text::parse_json<json>(gsim_run({main_, "--json", "--stop-at-first"}).out);
    EXPECT_EQ(r["alarm"]["line"], 3);
    EXPECT_TRUE(contains(r["alarm"]["file"], "O0002.nc"));
    EXPECT_TRUE(contains(report(main_)["violations"][0]["file"], "O0002.nc"));
}

TEST_F(CalledProgramFiles, ErrorsRaiseAlarmAtCall) {
    write("O0002.nc", "O2\nG999\nM99\n");
    const Ended e = gsim_run({main_, "--json"});
    EXPECT_EQ(e.status, 1);
    const json r = text::parse_json<json>(e.out);
    EXPECT_EQ(r["alarm"]["line"], 2);
    EXPECT_TRUE(contains(r["alarm"]["message"], "cannot be translated")) << r["alarm"];
    EXPECT_EQ(r["diagnostics"][1]["line"], 2) << r;
    EXPECT_TRUE(contains(r["diagnostics"][1]["file"], "O0002.nc")) << r;
    EXPECT_EQ(r["diagnostics"][1]["code"], "code-unknown") << r;
    EXPECT_EQ(r["diagnostics"][2]["code"], "program-missing") << r;
    EXPECT_TRUE(contains(gsim_run({main_}).err, "O0002.nc:2:"));
}

TEST_F(CalledProgramFiles, MissingFileRaisesAlarmAndTranslatorWarns) {
    EXPECT_EQ(report(main_)["alarm"]["line"], 2);
    const Ended e = gcode2lua({main_});
    EXPECT_EQ(e.status, 0);
    EXPECT_TRUE(contains(e.err, "wheel.nc:2:")) << e.err;
    EXPECT_TRUE(contains(e.err, "warning")) << e.err;
    std::filesystem::create_directories(folder_ / "O0002.nc");  // a folder is no program
    EXPECT_EQ(report(main_)["status"], "alarm");
}

TEST_F(CalledProgramFiles, RecursionEndsAtNestingLimit) {
    write("O0002.nc", "O2\nM98 P2\nM99\n");
    EXPECT_TRUE(contains(report(main_)["alarm"]["message"], "nested"));
}

}  // namespace
}  // namespace gsim::apps::programs_beside_test
