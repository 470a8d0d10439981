// A recorded run written again: the words of offsets, feeds, modes, switches and tools, and what is refused.
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::recorded_program_test {
namespace {

class RecordedProgram : public Apps {
  protected:
    Ended path2gcode(std::vector<std::string> arguments) const {
        return run_program(tests::program_path("path2gcode"), arguments, folder_);
    }
    void record(const std::string& program, const std::vector<std::string>& options = {}) const {
        write("data.txt", "NCFILE\nOFFSET\n54 200 150 -60\n55 10 20 30\nTOOL\n3 0 6\nENDFILE\n");
        std::vector<std::string> arguments{
            write("x.nc", program), "--machine-data", "data.txt",   "--quiet", "--record",
            "x.path.json",          "--moves",        "first.jsonl"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ended ran = gsim_run(arguments);
        ASSERT_EQ(ran.status, 0) << ran.err;
    }
    std::string written(std::vector<std::string> options = {}) const {
        options.insert(options.end(), {"x.path.json", "--quiet"});
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 0) << ended.err;
        return ended.out;
    }
    std::string rejection(std::vector<std::string> options) const {
        options.emplace_back("x.path.json");
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 1);
        EXPECT_EQ(ended.out, "");
        return ended.err;
    }
    // Returns the last position of a run of the written program.
    std::string last_place(const std::string& program, const std::string& dialect) const {
        const Ended ran = gsim_run({write("again.nc", program), "--dialect", dialect, "--machine-data",
                                    "data.txt", "--quiet", "--moves", "again.jsonl"});
        EXPECT_EQ(ran.status, 0) << ran.err << program;
        return place(read("again.jsonl"));
    }
    static std::string place(const std::string& moves) {
        const std::size_t at = moves.rfind("\"to\":");
        return moves.substr(at, moves.find('}', at) - at);
    }
};

// The specimen: machine coordinates under an active G54 drove the head 60 mm too deep.
TEST_F(RecordedProgram, EndsAtSamePositionWithAnyOffsets) {
    record("G21 G90 G0 X10 Y20 Z200\nG1 Z190 F600\nM30\n");
    const std::string first = place(read("first.jsonl"));
    EXPECT_EQ(first, R"("to":{"X":210,"Y":170,"Z":130,"B":0,"C":0)");
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        const auto text = [&](const std::string& offsets) {
            return written({"--dialect", dialect, "--offsets", offsets});
        };
        EXPECT_TRUE(contains(text("keep"), dialect == "ab9" ? "Z190.000" : "Z190 ")) << text("keep");
        EXPECT_TRUE(contains(text("none"), "G92 X0")) << text("none");
        EXPECT_TRUE(contains(text("G53"), "G53 G01 Z130")) << text("G53");
        for (const std::string offsets : {"keep", "none", "G53"})
            EXPECT_EQ(last_place(text(offsets), dialect), first) << dialect << offsets;
        EXPECT_EQ(text("keep"), written({"--dialect", dialect})) << "the default";
    }
}

TEST_F(RecordedProgram, BeginsWithProgrammedWordsOnly) {
    record("G21 G90 S1200 M3\nG1 X10 F600\nM30\n");
    EXPECT_EQ(written({"--dialect", "rs274ngc"}),
              "(x)\nG21 G17 G40 G49 G54 G80 G90 G94 G91.1\nG92.2\nS1200\nM3\nG01 X10 F600\nM2\n");
}

TEST_F(RecordedProgram, RepeatsToolsSpeedsSwitchesModesAndFeeds) {
    record(
        "T3\nM6\nS1200 M3\nG0 X10 Y10 Z200\nM8\nG93 G1 X50 F30\nG2 X70 I10 J0 F20\nG94 F500\nG61\nG1 Y40\n"
        "G64\nG48.1 X500 Y400\nG1 X20 F2000\nG48\nG95 G1 X60 F0.5\nG94\n#1103=1\nG4 P0.5\nG55\n"
        "G0 X100 Y100 Z50\nG33 Z45 F2\nG9 G1 X90 F700\nM1\nM19\nM9\nM5\nM30\n");
    EXPECT_EQ(written(),
              "O0001\nN00005 D1 H1\nN00010 G92.1\nN00015 G00 G17 G21 G40 G80 G90 G54 G94\nN00020 T3\n"
              "N00025 M06\nN00030 S1200\nN00035 M03\nN00040 G00 X10.000 Y10.000 Z200.000\nN00045 M08\n"
              "N00050 G93 G01 X50.000 F30\nN00055 G17 G02 X70.000 I10.000 J0.000 F20\nN00060 G61\n"
              "N00065 G94 G01 Y40.000 F500.000\nN00070 G64\nN00075 G48.1 X500\nN00080 G48.1 Y400\n"
              "N00085 X20.000 F2000.000\nN00090 G48\nN00095 G95 X60.000 F0.5\nN00100 #1103=1\n"
              "N00105 G04 P0.500\nN00110 G04 P0.000\nN00115 G55\n"
              "N00120 G00 X100.000 Y100.000 Z50.000 B0.000 C0.000\nN00125 G33 Z45.000 F2\n"
              "N00130 G09 G94 G01 X90.000 F700.000\nN00135 M01\nN00140 M19\nN00145 M09\nN00150 M05\n"
              "N00155 G92.1\nN00160 M02\n%\n");
}

// If the controller has a word for turns, an arc of several turns comes back as one block, helices included.
TEST_F(RecordedProgram, WritesMultiTurnArcAsOneBlock) {
    record("G21 G90 G0 X10 Y10 Z200\nG2 X10 Y10 I20 J0 P3 F600\nG3 X50 Y10 Z190 I20 J0 P2\nM2\n",
           {"--dialect", "rs274ngc"});
    const std::string ngc = written({"--dialect", "rs274ngc"});
    EXPECT_TRUE(contains(ngc, "G17 G02 X10 Y10 I20 J0 P3 F600\nG03 X50 Z190 I20 J0 P2\n")) << ngc;
    EXPECT_FALSE(contains(written(), " P"));
}

// LinuxCNC's M6 stops the spindle, the change of the recorded run did not: it went on cutting with it on.
TEST_F(RecordedProgram, RestartsSpindleAfterToolChange) {
    record("S1200 M4\nT3 M6\nG1 X10 F600\nM5\nM6\nG1 X20\nM30\n");
    const std::string ngc = written({"--dialect", "rs274ngc"});
    EXPECT_TRUE(contains(ngc, "S1200\nM4\nT3\nM6\nS1200\nM4\nG01 X10 F600\nM5\nM6\nX20\n")) << ngc;
    EXPECT_TRUE(contains(written(), "M06\nN00040 G01")) << written();
    record("S1200 M3\nM8\nM6\nG1 X10 F600\nM9\nM6\nM30\n");
    const std::string fanuc = written({"--dialect", "fanuc"});
    EXPECT_TRUE(contains(fanuc, "M06\nN70 S1200\nN80 M03\nN90 M08\nN100 G01 X10. F600.\n")) << fanuc;
    EXPECT_TRUE(contains(fanuc, "M09\nN120 M06\nN130 S1200\nN140 M03\n")) << fanuc;
}

// The same subprogram, once with the spindle on and once with it off.
TEST_F(RecordedProgram, RejectsToolChangeWithAmbiguousSpindleState) {
    record("M3\nG1 X10 F600\nM98 P2\nM5\nG1 X10\nM98 P2\nM30\n%\nO2\nM6\nG0 X20\nM99\n");
    EXPECT_EQ(
        rejection({"--dialect", "rs274ngc"}),
        "x.path.json:8:1: error: this controller stops the spindle to change the tool, and the paths that "
        "lead to this change have different states of it; switch it by an action before the change\n");
    EXPECT_TRUE(contains(written(), "M06\n"));
}

TEST_F(RecordedProgram, RejectsActionsUnknownToPost) {
    record("M10\nG48.1 X500\nG48.1 X600\nG1 X10 F600\nM30\n");
    EXPECT_EQ(rejection({"--dialect", "rs274ngc"}),
              "error: the post 'rs274ngc' has no words for 'ramp_limit acceleration X 500 mm', 'ramp_limit "
              "acceleration "
              "X 600 mm'; with --continue-on-unknown they become comments\n");
    const Ended went_on = path2gcode({"--dialect", "rs274ngc", "--continue-on-unknown", "x.path.json"});
    EXPECT_EQ(went_on.status, 0);
    EXPECT_EQ(went_on.err,
              "note: 'ramp_limit acceleration X 500 mm' is written as a comment, 1 times: the post "
              "'rs274ngc' has no block for it\nnote: 'ramp_limit acceleration X 600 mm' is written as a "
              "comment, 1 times: the post 'rs274ngc' has no block for it\n");
    EXPECT_TRUE(contains(went_on.out, "(action: ramp_limit acceleration X 500 mm)\n")) << went_on.out;
}

TEST_F(RecordedProgram, RejectsUnwritableOffsets) {
    record("G10 L2 P2 R30\nG55\nG0 X1 Y1 Z1\nM2\n", {"--dialect", "rs274ngc"});
    EXPECT_EQ(written({"--dialect", "rs274ngc"}).substr(0, 4), "(x)\n") << "turned by the program itself";
    write("hand.path.json",
          R"json({"paths": [{"name": "a", "targets": [{"position_mm": [1, 2, 3], "feed_mm_min": 9,
             "rotary_deg": {"B": 0, "C": 0}}]}]})json");
    EXPECT_EQ(path2gcode({"--offsets", "keep", "hand.path.json"}).err,
              "error: --offsets keep applies to recorded paths (gsim-run --record), which contain the active "
              "offsets\n");
    const auto recorded_in = [this](const std::string& offsets) {
        write("x.path.json", R"json({"work_offsets": )json" + offsets +
                                 R"json(, "paths": [{"name": "a", "targets": [{"position_mm": [1, 2, 3],
             "feed_mm_min": 9, "rotary_deg": {"B": 0, "C": 0}, "work_offset": "505"}]}]})json");
    };
    recorded_in(R"({"505": {"X": 1}})");
    EXPECT_EQ(rejection({"--dialect", "rs274ngc"}),
              "error: the post 'rs274ngc' has no word for the work offset G505; --offsets none or G53 writes "
              "the program without it\n");
    recorded_in(R"({"505": {}, "54": {"X": 1, "rotation_deg": 30}})");
    EXPECT_TRUE(contains(rejection({"--dialect", "ab9"}), "G505"));
    recorded_in(R"({"54": {"X": 1, "rotation_deg": 30}})");
    EXPECT_TRUE(contains(rejection({"--dialect", "ab9"}),
                         "'work_offset' is '505', which is not one of the program's 'work_offsets'"));
}

// Rotary axes keep their positions, full turns included, without an option.
TEST_F(RecordedProgram, KeepsTurnsOfRotaryAxes) {
    record("G21 G90 G0 X0 Y0 Z100\nG0 B350\nG0 B-350\nM30\n");
    EXPECT_TRUE(contains(written(), "B350.000\n")) << written();
}

}  // namespace
}  // namespace gsim::apps::recorded_program_test
