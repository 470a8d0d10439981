// Differences of grblHAL from LinuxCNC for words that both read: cycles, splines, feeds of rotary axes,
// stops.

#include <cmath>

#include "tests/lua_lib/ngc_run.h"
#include "tests/support/machine_path.h"

namespace gsim::script::grblhal_words_test {
namespace {

constexpr double kGrid_mm = 0.003;  // half of a step of 0.004 mm in X and Y

Conditions on(const std::string& machine) {
    Conditions setup = ngc_conditions();
    setup.machine = machine::load_machine(tests::machine_path(machine)).value();
    return setup;
}

Outcome run_on(const std::string& machine, const std::string& gcode) {
    return run_ngc("G21 G90 G94 G17\n" + gcode + "\nM2\n", on(machine));
}

double trapezoid(double length, double speed, double acceleration) {
    return trapezoid_s(length, speed, acceleration);
}

TEST(GrblHalCycles, PecksDwellAndFeedDownFromR) {
    const Outcome r = run_on("grblhal-router.toml", "G0 Z2\nG99 G83 X0 Y0 Z-6 R2 Q3 F600\nG80");
    ASSERT_TRUE(r.completed()) << r.message();
    // A dwell ends where it begins.
    std::vector<double> levels;
    for (std::size_t i = 0; i < r.moves.size(); ++i) levels.push_back(r.to(i, 'Z'));
    const std::vector<double> expected_value{2, -1, -1, 2, -4, -4, 2, -6, -6, 2};
    ASSERT_EQ(levels.size(), expected_value.size());
    for (std::size_t i = 0; i < expected_value.size(); ++i)
        EXPECT_NEAR(levels[i], expected_value[i], kGrid_mm) << i;
    EXPECT_NEAR(r.seconds(2), 0.25, 1e-9);
    EXPECT_NEAR(r.seconds(4), trapezoid(6, 10, 1000), 1e-6);  // by feed, from R to the second depth
}

TEST(GrblHalCycles, ChipBreakRetractsTenthOfMillimetre) {
    const Outcome r = run_on("grblhal-router.toml", "G0 Z2\nG99 G73 X0 Y0 Z-6 R2 Q3 F600\nG80");
    ASSERT_TRUE(r.completed()) << r.message();
    ASSERT_GE(r.moves.size(), 4U);
    EXPECT_NEAR(r.to(3, 'Z'), -0.9, kGrid_mm);
}

TEST(GrblHalCycles, IgnoresBoringWithWarning) {
    const Outcome r = run_on("grblhal-router.toml", "G0 Z5\nM3 S100\nG99 G85 X10 Y10 Z-6 R2 F600\nX30\nG80");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.moves.size(), 1U);
    ASSERT_FALSE(r.report.messages.warnings.empty());
    EXPECT_NE(r.report.messages.warnings.front().find("G85"), std::string::npos);
}

TEST(GrblHalSplines, ChordMidpointsStayWithinTenthOfMillimetre) {
    // Control points (0,0), (20,30), (40,0): y = 1.5 x - 0.0375 x^2.
    const Outcome r = run_on("grblhal-router.toml", "G5.1 X40 Y0 I20 J30 F3000");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.moves.size(), 20U);  // as recorded
    double x = 0, y = 0;
    for (std::size_t i = 0; i < r.moves.size(); ++i) {
        const double to_x = r.to(i, 'X'), to_y = r.to(i, 'Y');
        EXPECT_NEAR(to_y, 1.5 * to_x - 0.0375 * to_x * to_x, 2 * kGrid_mm);
        const double middle = (x + to_x) / 2;
        EXPECT_LT(1.5 * middle - 0.0375 * middle * middle - (y + to_y) / 2, 0.1 + 2 * kGrid_mm);
        x = to_x;
        y = to_y;
    }
    EXPECT_NEAR(x, 40, kGrid_mm);
}

// X50 A90: 1.8 deg a mm, A 360 deg/s2.
TEST(GrblHalFeeds, RotaryMoveUsesFeedOfTcpOrAllAxes) {
    const std::string move = "G1 X50 A90 F3000";
    const Outcome of_tool = run_on("grblhal-rotary.toml", move);
    ASSERT_TRUE(of_tool.completed()) << of_tool.message();
    EXPECT_NEAR(of_tool.seconds(0), trapezoid(50, 50, 360 / 1.8), 1e-6);
    const Outcome of_all = run_on("grblhal-rotary-nofix.toml", move);
    ASSERT_TRUE(of_all.completed()) << of_all.message();
    const double length = std::hypot(50, 90);
    EXPECT_NEAR(of_all.seconds(0), trapezoid(length, 50, 360 * length / 90), 1e-6);
    const Outcome standalone = run_on("grblhal-rotary.toml", "G1 A90 F3600");
    EXPECT_NEAR(standalone.seconds(0), trapezoid(90, 60, 360), 1e-6);
}

// Its planner knows four axes alike: between a turn and a line the junction is one of 90 degrees, as between
// lines.
TEST(GrblHalFeeds, LineAndRotaryMoveFormJunction) {
    const Outcome r = run_on("grblhal-rotary.toml", "G1 X20 F3000\nA45");
    ASSERT_TRUE(r.completed()) << r.message();
    // The change of direction is (-1, 1) / sqrt 2: A allows 360 sqrt 2 along it.
    const double sine = std::sqrt(0.5);
    const double speed = std::sqrt(360 * std::sqrt(2) * 0.01 * sine / (1 - sine));
    EXPECT_NEAR(r.segments.at(0).master.end_speed(), speed, 1e-6);
}

TEST(GrblHalStops, OccurOnlyForSynchronizingWords) {
    const auto stops_at = [](const std::string& word) {
        const Outcome r = run_on("grblhal-router.toml", "G1 X40 F3000\n" + word + "\nG1 X80");
        EXPECT_TRUE(r.completed()) << r.message();
        return r.segments.at(0).master.end_speed() == 0;
    };
    for (const char* word : {"M49", "G4 P0", "G92 X40", "G10 L2 P1 X5", "G43.1 Z1", "M3 S500", "M8", "T1 M6"})
        EXPECT_TRUE(stops_at(word)) << word;
    for (const char* word : {"M48", "G49", "G28.1", "M5", "M9", "T1", "G17", "F2000"})
        EXPECT_FALSE(stops_at(word)) << word;
}

}  // namespace
}  // namespace gsim::script::grblhal_words_test
