// Both routes from G-code to a report give the same: through a script, and directly.

#include <fstream>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::pipeline_test {
namespace {

using nlohmann::json;

class Pipeline : public Apps {
  protected:
    json parsed(const Ended& e) {
        json r = text::try_parse_json<json>(e.out);
        EXPECT_FALSE(r.is_discarded()) << e.out << e.err;
        if (r.is_object()) r.erase("program");
        return r;
    }
};

TEST_F(Pipeline, ScriptAndProgramGiveSameReport) {
    const std::filesystem::path wheel = tests::source_path("samples/wheel.nc");
    std::filesystem::copy_file(wheel, folder_ / "wheel.nc");
    const Ended lua = gcode2lua({"wheel.nc"});
    ASSERT_EQ(lua.status, 0);
    const json at_once = parsed(gsim_run({"wheel.nc", "--json"}));
    EXPECT_EQ(at_once["status"], "completed");
    EXPECT_EQ(parsed(gsim_run({"-", "--json"}, lua.out)), at_once);
    std::string of_file = gsim_run({write("wheel.lua", lua.out), "--json"}).out;
    ASSERT_EQ(text::parse_json<json>(of_file)["program"], "wheel.lua: wheel.nc");
    for (std::size_t at = 0; (at = of_file.find("wheel.lua: ", at)) != std::string::npos;)
        of_file.erase(at, std::string("wheel.lua: ").size());
    EXPECT_EQ(parsed({.status = 0, .out = of_file, .err = {}}), at_once);
}

// The first line of a script is its writer's word; the reports name the file that was opened.
TEST_F(Pipeline, ForgedFirstLineDoesNotHideFile) {
    write("good.nc", "G0 X5000\n");
    write("evil.lua", gcode2lua({"good.nc"}).out);
    const Ended run = gsim_run({"evil.lua"});
    EXPECT_TRUE(contains(run.out, "evil.lua: good.nc")) << run.out;
    EXPECT_EQ(parsed(gsim_run({"evil.lua", "--json"}))["violations"][0]["file"], "evil.lua: good.nc");
    const Ended check = run_program(tests::program_path("gsim"), {"check", "evil.lua"}, folder_);
    EXPECT_EQ(check.out.rfind("evil.lua: good.nc:1: ", 0), 0U) << check.out;
}

TEST_F(Pipeline, ScriptAndProgramGiveSameViolations) {
    write("part.nc", "O1\nG0 X10\nM98 P2\nM2\nO2\n#1=5\nG0 X[#1*1000]\nM99\n");
    const json at_once = parsed(gsim_run({"part.nc", "--json"}));
    EXPECT_EQ(at_once["violations"][0]["line"], 7);
    EXPECT_EQ(parsed(gsim_run({"-", "--json"}, gcode2lua({"part.nc"}).out)), at_once);
}

TEST_F(Pipeline, LocatesViolationInStandardInput) {
    const json r = parsed(gsim_run({"-", "--json"}, "G0 X10\nG0 X9999\n"));
    EXPECT_EQ(r["violations"][0]["file"], "stdin");
    EXPECT_EQ(r["violations"][0]["line"], 2);
}

TEST_F(Pipeline, EditedScriptReportsScriptLines) {
    write("part.nc", "G0 X10\nG0 X20\n");
    std::string lua = gcode2lua({"part.nc"}).out;
    lua.replace(lua.find("x=20"), 4, "x=-20");
    const json r = parsed(gsim_run({write("part.lua", lua), "--json"}));
    EXPECT_EQ(r["violations"][0]["file"], "part.lua");
    EXPECT_EQ(r["violations"][0]["line"], 3);  // line 2 of the G-code, below the line that opens the script
}

TEST_F(Pipeline, RunsScriptWithoutHeader) {
    const json r =
        parsed(gsim_run({write("hand.lua", "F(6000)\nfor i = 1, 4 do G1{x=i * 10.0} end\n"), "--json"}));
    EXPECT_EQ(r["status"], "completed");
    EXPECT_EQ(r["moves"], 4);
}

// The program runs in parts, and as a script at once: both give the same report.
TEST_F(Pipeline, LongProgramGivesSameReportAsScript) {
    std::string program = "G21 G90 F6000\n";
    for (int i = 1; i <= 60'000; ++i) program += "G1 X" + std::to_string(100 + i % 7) + "\n";
    write("long.nc", program + "G0 X0\nM2\n");
    const json at_once = parsed(gsim_run({"long.nc", "--json"}));
    EXPECT_EQ(at_once["status"], "completed");
    EXPECT_EQ(at_once["moves"], 60'001);
    EXPECT_EQ(parsed(gsim_run({"-", "--json"}, gcode2lua({"long.nc"}).out)), at_once);
    write("long.nc", program + "G0 X-5\nM2\n");
    EXPECT_EQ(parsed(gsim_run({"long.nc", "--json"}))["violations"][0]["line"], 60'002);
}

TEST_F(Pipeline, ScriptsPassLuaCompiler) {
    const Ended there = run_program("/usr/bin/env", {"luac5.4", "-v"}, folder_);
    if (there.status != 0) GTEST_SKIP() << "no luac5.4";
    write("part.lua", gcode2lua({tests::source_path("samples/wheel.nc")}).out);
    const Ended e = run_program("/usr/bin/env", {"luac5.4", "-p", "part.lua"}, folder_);
    EXPECT_EQ(e.status, 0) << e.err;
}

}  // namespace
}  // namespace gsim::apps::pipeline_test
