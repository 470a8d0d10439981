// Paths in work frames, with tools: written, run, recorded and written again.
#include <sstream>

#include "base/text/json.h"
#include "tests/apps/canon_ends.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::work_frames_test {
namespace {

using nlohmann::json;

const std::string kRouter = tests::source_path("samples/machines/router3.toml");

class WorkFrames : public Apps {
  protected:
    Ended path2gcode(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--machine", kRouter});
        return run_program(tests::program_path("path2gcode"), arguments, folder_);
    }
    std::string part() const {
        return write("part.path.json", R"json({"paths": [{"name": "part", "targets": [
            {"motion": "rapid", "position_mm": [10, 20, -10]},
            {"position_mm": [10, 20, -30], "feed_mm_min": 300},
            {"position_mm": [60, 20, -30]},
            {"motion": "circular", "position_mm": [60, 60, -30], "center_mm": [60, 40, -30], "turn_deg": 180},
            {"motion": "rapid", "position_mm": [60, 60, -10]}]}]})json");
    }
    std::string written(const std::string& dialect, std::vector<std::string> options) const {
        options.insert(options.end(), {"--quiet", "--dialect", dialect});
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 0) << ended.err;
        return ended.out;
    }
    /// Returns where the axes are driven to, and why.
    json driven(const std::string& program, const std::string& dialect,
                std::vector<std::string> options = {}) const {
        options.insert(options.end(), {write("x.nc", program), "--dialect", dialect, "--machine", kRouter,
                                       "--quiet", "--moves", "m.jsonl"});
        const Ended ran = gsim_run(options);
        EXPECT_EQ(ran.status, 0) << ran.err << program;
        json moves;
        std::istringstream lines(read("m.jsonl"));
        for (std::string line; std::getline(lines, line);) {
            const json move = text::parse_json<json>(line);
            if (move["kind"] == "dwell") continue;
            moves.push_back({{"kind", move["kind"]}, {"to", move["to"]}});
        }
        return moves;
    }
    static json shifted(json moves, double x, double y, double z) {
        for (json& move : moves) {
            move["to"]["X"] = move["to"]["X"].get<double>() + x;
            move["to"]["Y"] = move["to"]["Y"].get<double>() + y;
            move["to"]["Z"] = move["to"]["Z"].get<double>() + z;
        }
        return moves;
    }
    std::string data(const std::string& offsets, const std::string& tools = "") const {
        return write("data.txt", "NCFILE\nOFFSET\n" + offsets + "\nTOOL\n" + tools + "\nENDFILE\n");
    }
};

// The same path is shifted by the offset, whatever has set it.
TEST_F(WorkFrames, PathIsShiftedByItsFrame) {
    for (const std::string dialect : {"ab9", "fanuc", "rs274ngc", "grbl"}) {
        const std::string run_dialect = dialect == "fanuc" ? "ab9" : dialect == "grbl" ? "rs274ngc" : dialect;
        const json plain = driven(written(dialect, {part()}), run_dialect);
        ASSERT_GE(plain.size(), 5U) << dialect;
        const json expected_value = shifted(plain, 100, 50, 0);
        const std::string by_data = written(dialect, {part(), "--work-offset", "G55"});
        EXPECT_EQ(driven(by_data, run_dialect, {"--machine-data", data("54 1 2 3\n55 100 50 0")}),
                  expected_value)
            << by_data;
        const std::string set =
            written(dialect, {part(), "--work-offset", "G55", "--set-offset", "100", "50", "0"});
        EXPECT_EQ(driven(set, run_dialect, {"--machine-data", data("54 1 2 3\n55 7 7 7")}), expected_value)
            << set;
        const std::string first = written(dialect, {part(), "--set-offset", "100", "50", "0", "--inch"});
        EXPECT_EQ(driven(first, run_dialect, {"--machine-data", data("54 9 9 9")}).size(),
                  expected_value.size())
            << first;
    }
}

// Numbers are those of the path, words those of each controller, and no setting remains after the program.
TEST_F(WorkFrames, EachPostWritesItsWords) {
    const std::vector<std::string> options = {part(), "--work-offset", "G55", "--set-offset", "100", "50",
                                              "0",    "--tool",        "3"};
    EXPECT_EQ(
        written("rs274ngc", options),
        "(part)\nG21 G17 G40 G49 G54 G80 G90 G94 G91.1\nG92.2\nG10 L2 P2 X100 Y50 Z0 R0\nG53 G00 Z0\nT3\n"
        "M6\nG43 H3\nG55\nX10 Y20 Z-10\nG01 Z-30 F300\nX60\nG17 G03 Y60 I0 J20\nG00 Z-10\nG49\nG54\nM2\n");
    EXPECT_EQ(written("ab9", options),
              "O0001\nN00005 D1 H1\nN00010 G92.1\nN00015 G00 G17 G21 G40 G80 G90 G54 G94\n"
              "N00020 G10 L2 P2 X100.000 Y50.000 Z0.000\nN00025 G53 G00 Z0.000\nN00030 T3\nN00035 M06\n"
              "N00040 G43 H3\nN00045 G55\nN00050 X10.000 Y20.000 Z-10.000\nN00055 G01 Z-30.000 F300.000\n"
              "N00060 X60.000\nN00065 G17 G03 Y60.000 I0.000 J20.000\nN00070 G00 Z-10.000\nN00075 G49\n"
              "N00080 G54\nN00085 G92.1\nN00090 M02\n%\n");
    EXPECT_TRUE(
        contains(written("fanuc", options),
                 "N30 G10 L2 P2 X100. Y50. Z0.\nN40 G53 G00 Z0.\nN50 T3\nN60 M06\nN70 G43 H3\nN80 G55\n"));
    EXPECT_TRUE(
        contains(written("rs274ngc", {part(), "--tool", "3", "--retract", "-5"}), "G53 G00 Z-5\nT3\n"));
}

// A tool that is longer by 4 mm keeps its TCP on the path: Z is 4 mm higher, except on the move up.
TEST_F(WorkFrames, ToolLengthShiftsPath) {
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        const std::string program = written(dialect, {part(), "--work-offset", "G55", "--tool", "3"});
        const std::string offsets = "55 100 50 0";
        const json zero = driven(program, dialect, {"--machine-data", data(offsets, "3 0 6")});
        const json longer = driven(program, dialect, {"--machine-data", data(offsets, "3 4 6")});
        EXPECT_EQ(longer, shifted(zero, 0, 0, 4)) << program;
    }
}

TEST_F(WorkFrames, CutsOnePartOnTwoFixtures) {
    part();
    write("job.path.json", R"json({"root": "job", "paths": [
        {"name": "job", "targets": [{"path": "part", "work_offset": "G55", "set_offset_mm": [100, 50, -20]},
                                    {"path": "part", "work_offset": "G56", "set_offset_mm": [300, 50, -20]}]},
        {"name": "part", "targets": [{"motion": "rapid", "position_mm": [10, 20, 10]},
                                     {"position_mm": [10, 20, -5], "feed_mm_min": 300}]}]})json");
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        const json moves = driven(written(dialect, {"job.path.json"}), dialect);
        ASSERT_EQ(moves.size(), 5U);
        EXPECT_EQ(moves[2]["to"], (json{{"X", 110}, {"Y", 70}, {"Z", 0}})) << "up, before the other fixture";
        EXPECT_EQ(moves[1]["to"], (json{{"X", 110}, {"Y", 70}, {"Z", -25}}));
        EXPECT_EQ(moves[4]["to"], (json{{"X", 310}, {"Y", 70}, {"Z", -25}}));
    }
}

// Written, run, recorded and written again: the same moves; from then on the same text.
TEST_F(WorkFrames, RecordedRunKeepsFrameAndTool) {
    const std::string offsets = "54 1 2 3\n55 100 50 0";
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        const std::vector<std::string> options = {"--machine-data", data(offsets, "3 0 6"), "--record",
                                                  "again.path.json"};
        const std::string first = written(dialect, {part(), "--work-offset", "G55", "--tool", "3"});
        const json moves = driven(first, dialect, options);
        const std::string second = written(dialect, {"again.path.json"});
        for (const std::string word : {"T3\n", dialect == "ab9" ? "M06\n" : "M6\n", "G55\n"})
            EXPECT_TRUE(contains(second, word)) << word << second;
        EXPECT_TRUE(contains(second, dialect == "ab9" ? "Y60.000 I0.000 J20.000" : "Y60 I0 J20")) << second;
        EXPECT_EQ(driven(second, dialect, options), moves) << second;
        const std::string third = written(dialect, {"again.path.json"});
        EXPECT_EQ(third.substr(third.find("T3")), second.substr(second.find("T3")));
    }
}

// The run reports what the recorded path does not show as it was.
TEST_F(WorkFrames, RecordingReportsIncludedOffsets) {
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        const auto notes = [&](std::vector<std::string> options, const std::string& tools) {
            options.insert(options.begin(), part());
            const std::string program = write("p.nc", written(dialect, options));
            const Ended ran = gsim_run({program, "--dialect", dialect, "--machine", kRouter, "--machine-data",
                                        data("55 100 50 0", tools), "--record", "p.path.json"});
            EXPECT_EQ(ran.status, 0) << ran.err;
            return ran.out + ran.err;
        };
        const std::string moved = "the program has moved the work offset G";
        const std::string length = "tool offsets (G43) are included in its positions";
        const std::string none = notes({"--work-offset", "G55", "--tool", "3"}, "3 0 6");
        EXPECT_FALSE(contains(none, moved) || contains(none, length)) << none;
        EXPECT_TRUE(contains(notes({"--work-offset", "G55", "--tool", "3"}, "3 4 6"), length));
        EXPECT_TRUE(
            contains(notes({"--work-offset", "G55", "--set-offset", "90", "50", "0"}, ""), moved + "55"));
        EXPECT_TRUE(contains(notes({"--set-offset", "90", "50", "0"}, ""), moved + "54"))
            << "in force already";
    }
}

TEST_F(WorkFrames, RejectsUnsupportedFramesAndTools) {
    const auto rejected = [this](std::vector<std::string> options, int status = 1) {
        options.insert(options.begin(), part());
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, status);
        EXPECT_EQ(ended.out, "");
        return ended.err;
    };
    EXPECT_EQ(rejected({"--dialect", "grbl", "--work-offset", "G59.1"}),
              "error: the post 'grbl' has no work offset G59.1; it has G54, G55, G56, G57, G58, G59\n");
    EXPECT_EQ(rejected({"--dialect", "grbl", "--tool", "3"}),
              "error: the post 'grbl' has no words for 'tool_change T3', 'tool_length H3'; with "
              "--continue-on-unknown they "
              "become comments\n");
    EXPECT_TRUE(contains(rejected({"--tool", "3.5"}, 2), "--tool must be an integer"));
    EXPECT_EQ(rejected({"--tool", "3", "--retract", "9"}),
              "error: --retract: out of reach: Z 9 is outside -120 to 0\n");
    EXPECT_EQ(rejected({"--work-offset", "G55", "--offsets", "none"}),
              "error: --offsets applies to recorded paths; this path names its work offsets\n");
    EXPECT_TRUE(contains(rejected({"--tool", "3", "--dialect", "rs274ngc", "--offsets", "G53"}),
                         "--offsets G53 applies to paths that name no tools"));
    const Ended other =
        path2gcode({write("own.path.json", R"({"paths": [{"name": "part", "work_offset": "G54", "targets": [
            {"motion": "rapid", "position_mm": [10, 20, -10]}]}]})"),
                    "--work-offset", "G55", "--set-offset", "5", "6", "0"});
    EXPECT_EQ(other.err, "error: the path names G54, so G55 cannot be set for it\n");
    EXPECT_TRUE(
        contains(rejected({"--set-offset", "595", "0", "0"}), "out of reach: X 605 is outside 0 to 600"));
    driven(written("ab9", {part()}), "ab9", {"--record", "r.path.json"});
    EXPECT_EQ(path2gcode({"r.path.json", "--work-offset", "G55"}).err,
              "error: work offsets and tools apply to paths that are not recorded; a recorded path has them "
              "at its points\n");
}

TEST_F(WorkFrames, ReportsUncheckedRanges) {
    EXPECT_EQ(
        path2gcode({part(), "--work-offset", "G55", "-o", "o.nc"}).err,
        "note: the path does not define the position of G55, so the ranges of X, Y and Z are not checked\n");
}

TEST_F(WorkFrames, LinuxCncReadsProgram) {
    if (!has_rs274()) GTEST_SKIP() << "LinuxCNC's rs274 is not installed";
    write("c.ngc", written("rs274ngc", {part(), "--work-offset", "G55", "--set-offset", "100", "50", "0"}));
    const Ended canon = run_rs274(folder_, "c.ngc");
    EXPECT_EQ(canon.status, 0) << canon.err.substr(0, 2000);
}

}  // namespace
}  // namespace gsim::apps::work_frames_test
