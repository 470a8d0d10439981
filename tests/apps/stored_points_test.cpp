// Fixed and reference points of the machine data, from the file to the position of the machine.
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::stored_points_test {
namespace {

const std::string kData =
    "NCFILE\nOFFSET\n54 200 150 60\nFIXED\n1 100 50 300 NAME=PARK\n2 10 8 12 30 -45 NAME=CLAMP1 inch ; left\n"
    "REFERENCE\n2 400 500 100\nTOOL\n1 40 6\nENDFILE\n";

class StoredPoints : public Apps {
  protected:
    // The values of the axes at the end of a run, as --moves has them.
    std::string place_after(const std::string& program, const std::vector<std::string>& options = {}) const {
        write("d.txt", kData);
        std::vector<std::string> arguments{program, "--machine-data", "d.txt",   "--save-machine-data",
                                           "d.txt", "--quiet",        "--moves", "m.jsonl"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ended ran = gsim_run(arguments);
        EXPECT_EQ(ran.status, 0) << ran.err;
        EXPECT_EQ(read("d.txt"), kData) << "a run changes no point and no name";
        const std::string moves = read("m.jsonl");
        const std::size_t at = moves.rfind("\"to\":");
        return moves.substr(at, moves.find('}', at) - at);
    }
};

constexpr const char* kClamp = R"("to":{"X":254,"Y":203.2,"Z":304.8,"B":30,"C":-45)";

TEST_F(StoredPoints, ScriptMovesToPointByName) {
    const std::string script =
        write("part.lua",
              "local _ENV = require \"gsim\"\nprogram(1, function()\nG54() G43{h=1}\nG0{x=10, y=10}\n"
              "G53() G0(fixed \"CLAMP1\")\nM30()\nend)\n");
    EXPECT_EQ(place_after(script, {"--record", "part.path.json"}), kClamp);
    // The recording is a path, and a program of it leads there too.
    const Ended written =
        run_program(tests::program_path("path2gcode"), {"part.path.json", "--quiet"}, folder_);
    ASSERT_EQ(written.status, 0) << written.err;
    EXPECT_EQ(place_after(write("again.nc", written.out)), kClamp);
}

TEST_F(StoredPoints, ProgramMovesToPointByMCode) {
    const std::string setup = write("points.lua",
                                    "local _ENV = require \"gsim\"\n"
                                    "M[101] = function(words) G53() G0(fixed(words.p)) end\n"
                                    "M[102] = function(words) G53() G0(reference(words.p)) end\n");
    EXPECT_EQ(place_after(write("part.nc", "G54 G0 X1\nM101 P2\nM30\n"), {"--setup", setup}), kClamp);
    EXPECT_EQ(place_after(write("part.nc", "G54 G20 G0 X1\nM102 P2\nM30\n"), {"--setup", setup}),
              R"("to":{"X":400,"Y":500,"Z":100,"B":0,"C":0)");
}

TEST_F(StoredPoints, MissingPointRaisesAlarm) {
    write("d.txt", kData);
    const Ended ran =
        gsim_run({write("part.lua", "G53() G0(fixed \"CLAMP7\")\n"), "--machine-data", "d.txt"});
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(contains(ran.out + ran.err, "no fixed point has that name; available: 1 (PARK), 2 (CLAMP1)."))
        << ran.out << ran.err;
}

}  // namespace
}  // namespace gsim::apps::stored_points_test
