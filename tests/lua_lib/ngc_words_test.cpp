// RS274/NGC as LinuxCNC 2.9 reads it: EXISTS, bare feed modes, words that several codes read, names of
// O-words, threads without a pitch, what M72 writes. The wanted values are those that its interpreter gives
// for the same programs.

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::ngc_words_test {
namespace {

std::string variable_value(const std::string& expression, const std::string& before = "") {
    return debug_texts(run_ngc(before + "#100=" + expression + "\n(debug,%d#100)\nM2\n"));
}

TEST(NgcExists, ChecksRangeOfNumberedParameter) {
    EXPECT_EQ(variable_value("EXISTS[#1]"), "1\n");
    EXPECT_EQ(variable_value("EXISTS[#400]"), "1\n") << "without a value, too";
    EXPECT_EQ(variable_value("EXISTS[#5601]"), "1\n");
    EXPECT_EQ(variable_value("EXISTS[#5602]"), "0\n");
    EXPECT_EQ(variable_value("EXISTS[#0]"), "0\n");
    EXPECT_EQ(variable_value("EXISTS[##1]", "#1=5601\n"), "1\n");
    EXPECT_EQ(variable_value("EXISTS[##1]", "#1=9000\n"), "0\n");
    EXPECT_EQ(variable_value("EXISTS[##1]", "#1=-5\n"), "0\n");
    EXPECT_EQ(variable_value("EXISTS[#[1.00001]]"), "1\n");
    expect_alarm(run_ngc("#100=EXISTS[#[1.5]]\nM2\n"),
                 "the number of a parameter must be an integer, not 1.5");
}

TEST(NgcExists, ChecksValueOfNamedParameter) {
    EXPECT_EQ(variable_value("EXISTS[#<width>]"), "0\n");
    EXPECT_EQ(variable_value("EXISTS[#<width>]", "#<width>=0\n"), "1\n");
    EXPECT_EQ(variable_value("EXISTS[#<_metric>]"), "1\n");
}

TEST(NgcExists, SelectsBranch) {
    const Outcome r = run_ngc("G21\no1 if [EXISTS[#1]]\nG0 X1\no1 else\nG0 X2\no1 endif\nM2\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.to(0, 'X'), 1);
}

TEST(NgcParameters, NumberMayBeFunctionOrHaveSigns) {
    EXPECT_EQ(variable_value("#45", "#ATAN[1]/[1]=3\n"), "3\n");
    EXPECT_EQ(variable_value("#1", "#SIN[90]=4\n"), "4\n");
    EXPECT_EQ(variable_value("#2", "#ABS[-2]=5\n"), "5\n");
    EXPECT_EQ(variable_value("#3", "#-[-3]=6\n"), "6\n");
    EXPECT_EQ(variable_value("#+4", "#4=7\n"), "7\n");
    EXPECT_EQ(variable_value("#SQRT[16]", "#4=8\n"), "8\n");
}

TEST(NgcAngles, AreRoundedOnce) {
    EXPECT_EQ(variable_value("FIX[ACOS[SIN[-7]]]"), "97\n");
    EXPECT_EQ(variable_value("[SIN[30] EQ 0.5]"), "1\n");
    EXPECT_EQ(variable_value("[SIN[33.3]*2**53]"), "4945157917108571\n");
}

TEST(NgcCodes, RejectsUnsupportedCodesInScripts) {
    expect_alarm(run_ngc_lua("program(nil, function()\nG17_1()\nend)"), 2,
                 {"G17.1 (UV plane) is not supported"});
    expect_alarm(run_ngc_lua("G70{q=100}"), "G70 (lathe finishing cycle) is not supported");
}

TEST(NgcFeed, IsClearedByBareFeedMode) {
    for (const char* mode : {"G94", "G95"}) {
        const Outcome r = run_ngc(std::string("G21 F100 S100 M3\n") + mode + "\nG1 X1\nM2\n");
        expect_alarm(r, 3, {"[feed]", "no feed is active", "F"});
    }
    const Outcome kept = run_ngc("G21 F100\nG94 F50\nG1 X1\nM2\n");
    EXPECT_TRUE(kept.completed()) << kept.message();
    expect_alarm(run_ngc("G21 S100 M3\nG95 F1\nG1 X1\nG95\nG1 X2\nM2\n"), 5,
                 {"[feed]", "no feed is active", "F"});
}

TEST(NgcFeed, ParameterIgnoresInverseTimeFeed) {
    EXPECT_EQ(debug_texts(run_ngc("G21 F100\nG93\nG1 X1 F12\n(debug,%d#<_feed>)\nM2\n")), "100\n");
}

TEST(NgcSharedWords, AreReadByEachCodeOfBlock) {
    expect_alarm(run_ngc("G64 P0.1 M19 R90\nM2\n"), 1, {"[word-value]", "P of M19", "0, 1 or 2"});
    const Outcome r = run_ngc("G64 P1 M19 R90\nM2\n");
    ASSERT_EQ(r.report.events.size(), 1U) << r.message();
    EXPECT_EQ(r.report.events[0].detail, "90 deg, clockwise");
    EXPECT_EQ(run_ngc("M19 R90 Q2\nM2\n").report.events.at(0).detail, "90 deg, shortest way, within 2 s");
}

TEST(NgcSharedWords, AlsoApplyToModalMotion) {
    const Outcome r = run_ngc("G21 F1000\nG2 X10 I5\nG64 P3 X20 I5\nM2\n");
    ASSERT_EQ(r.moves.size(), 2U) << r.message();
    EXPECT_NEAR(r.moves[1].length_mm / r.moves[0].length_mm, 5, 1e-9) << "half a turn, and two more";
    const Outcome drill = run_ngc("G21 F1000\nG82 X1 Z-1 R1 P1\nG64 P3 X2\nG80\nM2\n");
    double dwell_s = 0;
    for (std::size_t n = 0; n < drill.moves.size(); ++n)
        if (drill.moves[n].length_mm == 0) dwell_s = drill.seconds(n);
    EXPECT_NEAR(dwell_s, 3, 1e-9) << drill.message();
    EXPECT_TRUE(run_ngc("G21 F1000\nG1 X10\nG64 P3 X20\nM2\n").completed()) << "a line has no use for P";
}

TEST(NgcThreads, ZeroPitchMovesAtFeed) {
    const Outcome r = run_ngc("G21 S100 M3 F60\nG33 Z-5 K0\nM2\n");
    ASSERT_EQ(r.moves.size(), 1U) << r.message();
    EXPECT_NEAR(r.seconds(0), 5, 0.5);
    expect_alarm(run_ngc("G21 S100 M3\nG33 Z-5 K0\nM2\n"), 2, {"[feed]", "no feed is active", "F"});
    expect_alarm(run_ngc("G21 F60\nG33 Z-5 K0\nM2\n"), 2, {"[spindle]", "G33", "stopped"});
    expect_alarm(run_ngc("G21 S100 M3\nG33 Z-5 K-1\nM2\n"), 2,
                 {"[word-value]", "pitch of G33", "greater than 0", "-1 mm"});
}

// 0.5 * 8 ** [1 / 1.5] is 2 but for its last digit: there are seven cuts and the last one, as in LinuxCNC.
TEST(NgcThreads, FullDepthWithinRoundingIsCutOnce) {
    const Outcome r =
        run_ngc("G21 S600 M3\nG18\nG0 X20 Z5\nG76 P1.66 Z-17.16 I-1 J0.5 R1.5 K2 Q0 H0 E0 L3\nM2\n");
    std::size_t cuts = 0;
    for (const simulation::RecordedMove& move : r.moves)
        if (move.info.kind == simulation::MoveKind::thread) ++cuts;
    EXPECT_EQ(cuts, 8U) << r.message();
}

TEST(NgcThreads, RequireZeroRadiusDuringCompensation) {
    const std::string path = "G1 X10\nG1 Y10\nG33.1 Z-5 K1\nG33 Z-6 K1\nG40\nM2\n";
    const Outcome r = run_ngc("G21 F100 S100 M3\nG41.1 D0\n" + path);
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.moves.size(), 5U);
    expect_alarm(run_ngc("G21 F100 S100 M3\nG41.1 D2\n" + path), 5,
                 {"G33.1 is not possible while cutter compensation is on"});
}

TEST(NgcPrograms, M98CallsFirstProgramOfNumberAfterMain) {
    const Outcome r = run_ngc("O0002\nG0 X1\nM98 P2\nM2\nO2\nG0 X2\nM99\nO2\nG0 X3\nM99\n");
    ASSERT_EQ(r.moves.size(), 2U) << r.message();
    EXPECT_EQ(r.to(1, 'X'), 2);
}

TEST(NgcSubroutines, NamesInAngleBracketsKeepLeadingZeros) {
    const Outcome r = run_ngc(
        "o<0002> sub\nG0 X3\no<0002> endsub\no2 sub\nG0 X2\no2 endsub\n"
        "o<0002> call\no2 call\no<0002> call\no<2> call\no0002 call\nM2\n");
    ASSERT_EQ(r.moves.size(), 4U) << r.message() << " (the last two are where the tool is)";
    EXPECT_EQ(r.to(0, 'X'), 3);
    EXPECT_EQ(r.to(1, 'X'), 2);
    EXPECT_EQ(r.to(2, 'X'), 3);
    EXPECT_EQ(r.to(3, 'X'), 2);
}

TEST(NgcSubroutines, NumberedProgramReturnsNoValue) {
    EXPECT_EQ(
        debug_texts(run_ngc("o1 sub\no1 endsub [5]\no1 call\n(debug,%d#<_value>)\nM98 P7\n"
                            "(debug,%d#<_value> #<_value_returned>)\nM2\nO7\n(debug,%d#<_value>)\nM99\n")),
        "5\n5\n0 0\n");
}

TEST(NgcModes, FeedAndSpeedAreRestoredAsInLinuxcnc) {
    const std::string display_text = "M72\n(debug,%.3f#<_feed> #<_rpm>)\nM2\n";
    EXPECT_EQ(debug_texts(run_ngc("G21 F92.987 S100.6 M3\nM70\nF33 S120\n" + display_text)),
              "93.000 101.000\n");
    EXPECT_EQ(debug_texts(run_ngc("G21 F92.987 S100.6 M3\nM70\nG91\n" + display_text)), "92.987 100.600\n")
        << "what has not changed is not written";
    EXPECT_EQ(debug_texts(run_ngc("G21 F92.987 S100.6 M3\nM70\nG93\n" + display_text)), "0.000 100.600\n")
        << "G94 drops F, and F had not changed";
}

TEST(NgcTools, EmptySpindleHasPocketZero) {
    EXPECT_EQ(variable_value("#<_current_pocket>"), "0\n");
}

}  // namespace
}  // namespace gsim::script::ngc_words_test
