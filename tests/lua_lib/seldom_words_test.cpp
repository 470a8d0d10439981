// Words that programs seldom hold: boring with stops, changes of side on arcs, angles of corners that are
// left open, tables of tools in lines. Points are worked out by hand.

#include <algorithm>
#include <cmath>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::seldom_words_test {
namespace {

constexpr double kClose_mm = 1e-4;

bool ends_at(const Outcome& run, double x, double y) {
    return std::any_of(run.moves.begin(), run.moves.end(), [&](const simulation::RecordedMove& move) {
        const auto n = static_cast<std::size_t>(&move - run.moves.data());
        return std::hypot(run.to(n, 'X') - x, run.to(n, 'Y') - y) < kClose_mm;
    });
}

// --- Boring ---

const std::string kHole = "F600 S100 M3\nG90 G0 X10 Y10 Z100\nG99\n";

TEST(Boring, G86StopsSpindleAtBottomAndRetractsByRapid) {
    const Outcome r = run(kHole + "G86 Z40 R60 P1\nM30\n");
    EXPECT_EQ(r.events().substr(0, 33), "spindle_cw spindle_off spindle_cw") << r.events();
    ASSERT_EQ(r.moves.size(), 5U) << "to the place, R, the bottom, the dwell, R";
    EXPECT_NEAR(r.to(2, 'Z'), 40, kClose_mm);
    EXPECT_EQ(r.moves[2].info.kind, simulation::MoveKind::linear);
    EXPECT_NEAR(r.seconds(3), 1, 1e-6);
    EXPECT_NEAR(r.to(4, 'Z'), 60, kClose_mm);
    EXPECT_EQ(r.moves[4].info.kind, simulation::MoveKind::rapid);
}

TEST(Boring, G88StopsForOperatorAtBottom) {
    const Outcome r = run(kHole + "G88 Z40 R60\nM30\n");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.events().substr(0, 38), "spindle_cw spindle_off stop spindle_cw") << r.events();
    EXPECT_NEAR(r.moves.back().info.location.line, 4, 0);
    EXPECT_NEAR(r.end()[2], 60, kClose_mm);
}

TEST(Boring, G89FeedsOutAfterDwell) {
    const Outcome r = run(kHole + "G89 Z40 R60 P2\nM30\n");
    ASSERT_EQ(r.moves.size(), 5U) << r.message();
    EXPECT_NEAR(r.seconds(3), 2, 1e-6);
    EXPECT_EQ(r.moves[4].info.kind, simulation::MoveKind::linear) << "no rapid: R is where it ends";
    EXPECT_NEAR(r.to(4, 'Z'), 60, kClose_mm);
}

// --- Compensation of the 9/Series with a change of side ---

// A tool of radius 3.
Outcome run_compensated(const std::string& gcode) {
    Conditions setup = ngc_conditions();
    setup.options.dialect = "ab9";
    setup.options.data.tools[1] = {.length_mm = 0, .diameter_mm = 6};
    return run("G21 F1000\nG0 X-30 Y0\n" + gcode + "G40\nG1 X-30 Y40\nM30\n", setup);
}

// The tool passes the intersection of both paths: a line 3 off y = 0, and a circle of radius 10 - 3 about
// (10, 0).
TEST(CompensationSideChange, PassesIntersectionOfLineAndCircle) {
    const double x = 10 + std::sqrt(7 * 7 - 3 * 3);
    const Outcome out = run_compensated("G41 D1\nG1 X0\nX20\nG42\nG2 X20 Y0 I-10 J0\n");
    EXPECT_TRUE(out.completed()) << out.message();
    EXPECT_TRUE(ends_at(out, x, 3));
    const Outcome in = run_compensated("G1 X20 Y-20\nG42 D1\nX20 Y0\nG2 X20 Y0 I-10 J0\nG41\nG1 X0\n");
    EXPECT_TRUE(in.completed()) << in.message();
    EXPECT_TRUE(ends_at(in, x, -3));
}

TEST(CompensationSideChange, PassesIntersectionOfTwoCircles) {
    const double half_chord = std::sqrt(7 * 7 - 10.0), d = std::sqrt(40.0);
    const Outcome r =
        run_compensated("G1 X20 Y-20\nG42 D1\nX20 Y0\nG2 X20 Y0 I-10 J0\nG41\nG3 X20 Y0 I-8 J6\n");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_TRUE(ends_at(r, 11 + half_chord * 6 / d, 3 - half_chord * 2 / d));
}

// --- Angles (,A) ---

TEST(OpenAngles, RequireNextLineWithAngle) {
    const std::string start = "F600\nG0 X0 Y0\nG1 ,A30\n";
    for (const char* next : {"G0 X10\n", "G2 X10 Y0 I5 J0\n", "M30\n"}) {
        expect_alarm(run(start + next), 4, {"[corner]", ",A without an end", "a next block with ,A"});
    }
    expect_alarm(run("F600\nG2 X10 Y0 I5 J0\nX5 ,A30\n"), ",A applies to straight moves (G0, G1)");
    expect_alarm(run("F600\nG0 X10 Y0\nG16\nG1 X5 Y30 ,A30\n"), 4, {"polar programming (G16)"});
    expect_alarm(run("F600\nG1 X5 ,A30 U3\n"), 2, {"not with the increment U"});
}

// --- RS274/NGC ---

TEST(RareNgcWords, RejectsPolarIncrementAtZeroPoint) {
    expect_alarm(run_ngc("G21 F100\nG0 X0 Y0 Z10\nG91 G81 @0 ^30 R0 Z-5 L2\n"),
                 "no direction at the zero point");
}

TEST(RareNgcWords, G10WritesFullToolAndRejectsInvalidOrientation) {
    const Outcome r =
        run_ngc("G21\nG10 L1 P1 Z12 R4 I30 J-30 Q3\nT1 M6 G43\n(debug,#5403 #5410 #5411 #5412 #5413)\n");
    EXPECT_EQ(debug_texts(r), "0.472441 0.314961 30.000000 -30.000000 3.000000\n")
        << "12 mm and twice 4 mm in the unit of parameters, inches";
    expect_alarm(run_ngc("G10 L1 P1 Q10\n"), "Q of G10 L1 (tool orientation) must be an integer from 0 to 9");
    expect_alarm(run_ngc("G10 L1 P1 Q1.5\n"),
                 "Q of G10 L1 (tool orientation) must be an integer from 0 to 9");
}

}  // namespace
}  // namespace gsim::script::seldom_words_test
