// Words that switch the machine's process, and the errors that a run finds in it.

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::process_test {
namespace {

using machine::ProcessKind;
using machine::SwitchWord;

Conditions with_process(ProcessKind kind, std::vector<SwitchWord> on, std::vector<SwitchWord> off,
                        const char* dialect = "rs274ngc") {
    Conditions setup;
    setup.options.dialect = dialect;
    setup.machine.process =
        machine::Process{.kind = kind, .on = std::move(on), .off = std::move(off), .checks = {.dwell_s = 2}};
    return setup;
}

Conditions jet(const char* dialect = "ab9") {
    return with_process(ProcessKind::jet, {{.code = 8, .words = {}}}, {{.code = 9, .words = {}}}, dialect);
}

Conditions mill() {
    return with_process(ProcessKind::spindle, {{3, {}}, {4, {}}}, {{5, {}}});
}

std::string findings(const Outcome& run) {
    std::string list;
    for (const simulation::ProcessFinding& finding : run.report.findings.list)
        list += fmt::format("{}:{} ", finding.location.line, text::diagnostic_code(finding.kind));
    return list;
}

TEST(Process, MachineFileDefinesSwitchWords) {
    const char* program =
        "G21 F6000\nM62 P0\nG1 X10\nM63 P0\nG1 X30\nM101\nG1 X60\nM102\nG1 X100\nM62 P1\nG1 X150\nM8\nG1 "
        "X200\nM2\n";
    const Outcome run = script::run(program, with_process(ProcessKind::laser, {{62, {{'P', 0}}}, {101, {}}},
                                                          {{63, {{'P', 0}}}, {102, {}}}));
    ASSERT_TRUE(run.completed()) << run.message();
    EXPECT_NEAR(run.report.distances.process_on_mm, 10 + 30, 1e-9);
    EXPECT_EQ(run.report.source.process, "laser");
    EXPECT_EQ(run.events(), "laser_on laser_off laser_on laser_off digital_output flood_on");
    EXPECT_EQ(run.report.events[0].detail, "M62 P0");
}

TEST(Process, SameWordSwitchesInEachDialect) {
    for (const char* dialect : {"ab9", "rs274ngc"}) {
        const Outcome run = script::run("G21\nM8\nG1 X10 F6000\nM9\nG0 X30\nM30\n", jet(dialect));
        EXPECT_NEAR(run.report.distances.process_on_mm, 10, 1e-9) << dialect;
        EXPECT_EQ(run.events(), "jet_on jet_off") << dialect;
        EXPECT_EQ(findings(run), "") << dialect;
    }
}

// M62 switches at the start of the next motion; a dwell is none.
TEST(Process, OutputWithNextMoveIsOffDuringDwell) {
    const Outcome run = script::run("G21 F6000\nM62 P0\nG4 P5\nG1 X10\nM64 P1\nG4 P5\nM2\n",
                                    with_process(ProcessKind::jet, {{62, {}}, {64, {{'P', 1}}}}, {{63, {}}}));
    ASSERT_EQ(run.moves.size(), 3U);
    EXPECT_FALSE(run.moves[0].info.process_on);
    EXPECT_TRUE(run.moves[1].info.process_on);
    EXPECT_EQ(findings(run), "6:dwell-with-process-on 7:end-with-process-on ");
}

TEST(Process, UserCodeSwitchesAndRunsItsDefinition) {
    Conditions setup = with_process(ProcessKind::plasma, {{101, {}}}, {{102, {}}}, "ab9");
    const Outcome run = run_lua(
        "M[101] = function(words) G4{p=words.q} end F(6000)\nM[101]{q=1} G1{x=10} M[102]() G1{x=20}", setup);
    ASSERT_TRUE(run.completed()) << run.message();
    EXPECT_NEAR(run.report.times.dwell_s, 1, 1e-9);
    EXPECT_NEAR(run.report.distances.process_on_mm, 10, 1e-9);
    EXPECT_EQ(run.events(), "plasma_on plasma_off");
}

TEST(Process, ToolChangeAndOrientationSwitchSpindleOff) {
    const Outcome run =
        script::run("G21 F600 M3 S100\nG1 X10\nM6\nG1 X20\nM4\nG1 X30\nM19\nG1 X40\nM2\n", mill());
    ASSERT_TRUE(run.completed()) << run.message();
    EXPECT_NEAR(run.report.distances.process_on_mm, 20, 1e-9);
    EXPECT_EQ(run.report.events[0].kind, "spindle_cw");
    EXPECT_EQ(findings(run), "4:feed-with-spindle-off 8:feed-with-spindle-off ");
}

TEST(Process, ReportsFindingsOfJet) {
    const char* program =
        "G1 F6000 Z10\nG0 X10\nM8\nG4 P3\nG1 X50\nG0 X60\nG0 X70\nM9\nG0 Y5\nG1 X90\nG1 Y20\nM9\nG0 Z50\nG1 "
        "X0\nG0 Z60\nM8\n"
        "M30\n";
    const Outcome run = script::run(program, jet());
    EXPECT_EQ(
        findings(run),
        "4:dwell-with-process-on 6:rapid-with-process-on 10:feed-with-process-off 17:end-with-process-on ");
    ASSERT_EQ(run.report.findings.list.size(), 4U);
    EXPECT_EQ(run.report.findings.list[0].message,
              "a dwell of 3 s with the jet on; the machine file allows 2 s");
    EXPECT_EQ(run.report.findings.list[1].message, "a rapid move with the jet on");
    EXPECT_EQ(run.report.findings.list[2].message,
              "a feed move with the jet off, at a height at which the program cuts");
    EXPECT_EQ(run.report.findings.list[3].message, "the program ends with the jet on");
    EXPECT_EQ(run.report.status, simulation::RunStatus::completed);
}

// The jet is switched on at the end of the path, which leads to the next cut.
TEST(Process, AcceptsFeedMoveToNextCut) {
    EXPECT_EQ(
        findings(script::run("G1 X10 F6000\nM8\nG1 X50\nM9\nG1 X60\nG1 Y5\nM8\nG1 X70\nM9\nM30\n", jet())),
        "");
    // Here it was forgotten: what follows the contour switches it off.
    EXPECT_EQ(
        findings(script::run("M8\nG1 X50 F6000\nM9\nG0 X60\nG1 X80\nM9\nG1 X90\nM8\nX95\nM9\nM30\n", jet())),
        "5:feed-with-process-off ");
}

TEST(Process, EachCheckCanBeSwitchedOff) {
    const char* program = "M8\nG4 P3\nG1 X50 F6000\nG0 X60\nM9\nG1 X70\nG0 X80\nM8\nM30\n";
    EXPECT_EQ(
        findings(script::run(program, jet())),
        "2:dwell-with-process-on 4:rapid-with-process-on 6:feed-with-process-off 9:end-with-process-on ");
    struct {
        bool machine::ProcessChecks::*flag;
        const char* left;
    } const cases[] = {{&machine::ProcessChecks::dwell_with_process_on,
                        "4:rapid-with-process-on 6:feed-with-process-off 9:end-with-process-on "},
                       {&machine::ProcessChecks::rapid_with_process_on,
                        "2:dwell-with-process-on 6:feed-with-process-off 9:end-with-process-on "},
                       {&machine::ProcessChecks::feed_with_process_off,
                        "2:dwell-with-process-on 4:rapid-with-process-on 9:end-with-process-on "},
                       {&machine::ProcessChecks::end_with_process_on,
                        "2:dwell-with-process-on 4:rapid-with-process-on 6:feed-with-process-off "}};
    for (const auto& check : cases) {
        Conditions setup = jet();
        setup.machine.process->checks.*check.flag = false;
        EXPECT_EQ(findings(script::run(program, setup)), check.left);
    }
}

TEST(Process, AcceptsSpindleOnUntilProgramEnd) {
    EXPECT_EQ(findings(script::run("G21 F600 M3 S100\nG1 X10\nM2\n", mill())), "");
    Conditions setup = mill();
    setup.options.dialect = "ab9";
    EXPECT_EQ(findings(run_lua("F(600) S(100) M3()\nG1{x=10}", setup)), "2:end-with-process-on ");
}

TEST(Process, Ab9M8IsJetWithoutChecksByDefault) {
    Conditions setup;
    setup.machine.process.reset();
    const Outcome run = script::run("M8\nG1 X10 F6000\nG0 X20\nM30\n", setup);
    EXPECT_NEAR(run.report.distances.process_on_mm, 10, 1e-9);
    EXPECT_EQ(findings(run), "");
}

}  // namespace
}  // namespace gsim::script::process_test
