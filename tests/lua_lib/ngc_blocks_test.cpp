// RS274/NGC: the effect of complete blocks. The expected values are those that LinuxCNC's interpreter (rs274
// -g) gives for the same programs.

#include <fmt/format.h>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::ngc_blocks_test {
namespace {

// X of the end of the last move.
double last_x(const Outcome& run) {
    EXPECT_TRUE(run.completed()) << run.message();
    return run.moves.empty() ? -1 : run.to(run.moves.size() - 1, 'X');
}

double last_y(const Outcome& run) {
    EXPECT_TRUE(run.completed()) << run.message();
    return run.moves.empty() ? -1 : run.to(run.moves.size() - 1, 'Y');
}

TEST(NgcBlockValues, ReadStateBeforeBlock) {
    EXPECT_NEAR(last_y(run_ngc("G21 G0 X10\nG20 G0 Y#5420\nM2\n")), 254, 1e-9) << "10, then in inches";
    EXPECT_NEAR(last_x(run_ngc("G21 G0 X10\nG91 X[10*#<_absolute>]\nM2\n")), 20, 1e-9);
    EXPECT_NEAR(last_x(run_ngc("G21 F20\nG0 X1\nF50 G1 X#<_feed>\nM2\n")), 20, 1e-9);
    EXPECT_NEAR(last_x(run_ngc("G21\nG0 X10 F20\nS50 M3 G0 X[#<_spindle_on>*5+#<_rpm>]\nM2\n")), 0, 1e-9);
    EXPECT_NEAR(last_x(run_ngc("G21 #1=5\nG0 X1 #1=7\nX#1\nM2\n")), 7, 1e-9);
    EXPECT_NEAR(last_x(run_ngc("G21 #1=5\nG0 X#1 #1=7\nM2\n")), 5, 1e-9);
}

/// A block sets its parameters before it acts: a call, an alarm or the end of the program finds them set.
TEST(NgcBlockValues, ParametersAreSetBeforeCodesRun) {
    EXPECT_EQ(debug_texts(run_ngc("G21 G0 X3\n#1=[#5420+1] G0 X5\n(debug,#1)\nM2\n")), "4.000000\n");
    EXPECT_NEAR(last_x(run_ngc("G21\nG28 #5161=2\nG28 Y0\nM2\n")), 50.8, 1e-9)
        << "G28 goes where the block sets it";
    EXPECT_EQ(debug_texts(run_ngc("#1=1\n#1=2 (debug,#1)\n(debug,#1) #1=[#1+1]\nM2\n")),
              "2.000000\n3.000000\n")
        << "comments see them too";
}

TEST(NgcNumbers, AcceptNearIntegersForToolsRepeatsAndTurns) {
    const char* const three = "[.1*3*10]";  // a little more than 3
    EXPECT_EQ(run_ngc(fmt::format("M98 P{}\nM2\nO3\nG0 X1\nM99\n", three)).moves.size(), 1U);
    EXPECT_EQ(run_ngc(fmt::format("G21 F100\nG81 X1 Z-1 R1 L{}\nM2\n", three)).moves.size(),
              run_ngc("G21 F100\nG81 X1 Z-1 R1 L3\nM2\n").moves.size());
    const Outcome turns = run_ngc(fmt::format("G21 F100\nG2 X2 I1 P{}\nM2\n", three));
    ASSERT_EQ(turns.moves.size(), 1U) << turns.message();
    EXPECT_NEAR(turns.moves[0].length_mm, run_ngc("G21 F100\nG2 X2 I1 P3\nM2\n").moves.at(0).length_mm, 1e-9);
    EXPECT_TRUE(run_ngc("T[.1*20] M6\nG43 H[.1*10.0005]\nG41 D[.1*20.0005]\nM2\n").completed());
    expect_alarm(run_ngc("G21\nT1.001 M6\nM2\n"), 2, {"[word-value]", "T must be an integer", "1.001"});
    expect_alarm(run("G21\nT[.1*3*10]\nM2\n"), 2, {"[word-value]", "T must be an integer", "not 3"});
}

/// LinuxCNC compares exactly, so rounding may leave a last peck of almost zero.
TEST(NgcCycles, PecksAreCountedExactly) {
    const Outcome r = run_ngc("G21 F100\nG83 X1 Z-1 R1 Q.1\nM2\n");
    std::size_t strokes = 0;
    for (const simulation::RecordedMove& move : r.moves)
        strokes += move.info.kind == simulation::MoveKind::linear;
    double depth = 1 - .1;
    std::size_t expected_value = 1;  // to the bottom
    for (; depth > -1; depth -= .1) ++expected_value;
    EXPECT_EQ(strokes, expected_value);
}

TEST(NgcPolar, AngleAloneAtZeroPointHasZeroRadius) {
    EXPECT_NEAR(last_x(run_ngc("G21 F100\nG1 ^45\nX5\nM2\n")), 5, 1e-9);
    expect_alarm(run_ngc("G21 F100\nG1 @5\nM2\n"), 2, {"@ without ^"});
    expect_alarm(run_ngc("G21 F100\nG91 G1 @5 ^5\nM2\n"), 2, {"zero point"});
}

TEST(NgcPrograms, BareOWordIsOnlyLabel) {
    EXPECT_NEAR(last_x(run_ngc("G21 G90\nO0001\nG0 X1\nM30\n")), 1, 1e-9);
    EXPECT_EQ(run_ngc("G21\nG0 X5\nO0001\nG0 X1\nM30\n").moves.size(), 2U);
    EXPECT_EQ(run_ngc("O1\nG0 X1\nM98 P2\nG0 X5\nM2\nO2\nG0 X2\nO3\nG0 X3\nM99\n").moves.size(), 4U)
        << "a program that is called goes on into the next one";
    EXPECT_EQ(run_ngc("O1\nG0 X1\nO2\nG0 X2\nM99\nG0 X5\n").moves.size(), 2U) << "M99 ends the run";
    EXPECT_EQ(run_ngc("O1\nG0 X1\nM2\nO2\nG0 X2\nM99\n").moves.size(), 1U);
    EXPECT_EQ(run("O1\nG0 X1\nO2\nG0 X2\nM99\n").moves.size(), 1U) << "in the 9/Series a program ends there";
}

const std::string kLeftCompensation = "G21 F1000\nG0 X0 Y0 Z5\nG42.1 D10\nG1 X20\n";

TEST(NgcCompensation, CommentsAndNamesReportToolPosition) {
    const std::string where = "(debug,%d#<_x> #<_y> #5420 #5421)\n";
    EXPECT_EQ(debug_texts(run_ngc(kLeftCompensation + where + "X30\n" + where + "Y10\n" + where +
                                  "X5\nG40 X0\n" + where + "M2\n")),
              "20 -5 20 -5\n30 -5 30 -5\n35 10 35 10\n0 10 0 10\n");
    EXPECT_EQ(debug_texts(run_ngc(kLeftCompensation + "#1=#<_x>\n(debug,%d#1)\nX30\nG40\n" + where + "M2\n")),
              "20\n30 0 30 0\n");
    expect_alarm(run_ngc(kLeftCompensation + "#1=#5420\nM2\n"), 5, {"#5420", "compensation"});
}

TEST(NgcCompensation, ParameterReportsSideOnly) {
    EXPECT_EQ(debug_texts(run_ngc("G42.1 D5\n(debug,%d#<_ccomp>)\nG40\n(debug,%d#<_ccomp>)\nM2\n")),
              "420\n400\n");
}

TEST(NgcCompensation, IgnoresG923) {
    const Outcome r = run_ngc("G92 X5\nG92.2\n" + kLeftCompensation + "G92.3\nX30\nG40\nX0\nM2\n");
    EXPECT_NEAR(last_x(r), 0, 1e-9) << "the offset is not in force";
    ASSERT_FALSE(r.report.messages.warnings.empty());
    EXPECT_NE(r.report.messages.warnings.back().find("G92.3"), std::string::npos);
}

TEST(NgcComputedCodes, ActLikeWrittenCodes) {
    EXPECT_NEAR(last_x(run_ngc("G21\nG[#<_metric>+19]\nG0 X1\nM2\n")), 25.4, 1e-9) << "G20";
    EXPECT_NEAR(last_x(run_ngc("#1=59.1 #5341=2\nG#1 G0 X0\nM2\n")), 50.8, 1e-9);
    EXPECT_NEAR(last_x(run_ngc("G21 F100\n#1=2\nG#1 X2 I1\nM2\n")), 2, 1e-9) << "the words go on with it";
    EXPECT_EQ(run_ngc("#1=3\nM#1 S100\nM[5]\nM2\n").events(), run_ngc("M3 S100\nM5\nM2\n").events());
    EXPECT_NEAR(last_x(run_ngc("G21\nG[0.9999999] X1 F5\nM2\n")), 1, 1e-9);
    const Outcome user = run_ngc_lua("M[101] = function() G0{x=4.0} end code('M', 101.0)");
    EXPECT_NEAR(last_x(user), 4, 1e-9);
}

TEST(NgcComputedCodes, RejectsUnsupportedNumbers) {
    for (const char* code : {"G[4]", "G[28]", "G[1.5]", "G[-1]", "G[10**9]", "M[2]", "M[98]", "M[6]",
                             "M[3.5]", "G[777]", "G[10**300]", "M[-3]"}) {
        const Outcome r = run_ngc(std::string("G21\n") + code + "\nM2\n");
        EXPECT_EQ(r.report.status, simulation::RunStatus::alarm) << code;
        EXPECT_EQ(r.line(), 2U) << code;
    }
    expect_alarm(run_ngc("G21\nG[28]\nM2\n"), 2, {"G28", "computed number", "write the number directly"});
    expect_alarm(run_ngc_lua("code('X', 1)"), 1, {"code()"});
    expect_alarm(run_ngc_lua("code('G')"), 1, {"code()"});
    expect_alarm(run_ngc_lua("code('G', 1/0)"), 1, {"Ginf", "computed number", "write the number directly"});
}

}  // namespace
}  // namespace gsim::script::ngc_blocks_test
