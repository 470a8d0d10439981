// Automatic corner override (G62): the feed is lowered near inside corners of cutter compensation, and takes
// the time for it. Accelerations are unlimited, so that each part takes its length by its feed.

#include <cmath>
#include <limits>
#include <string>

#include "tests/lua_lib/run.h"

namespace gsim::script::corner_override_test {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// Returns conditions with half the feed from 3 mm before corners of up to 90 degrees to 5 mm after them; tool
// 1 has a radius of 2 mm.
Conditions conditions(double percent = 50, double before_mm = 3, double after_mm = 5, double angle_deg = 90) {
    Conditions setup;
    setup.options.data.tools[1] = {.length_mm = 0, .diameter_mm = 4};
    setup.options.data.tools[3] = {.length_mm = 0, .diameter_mm = 0};
    rrs::ControllerRules& rules = setup.machine.controller;
    rules.planner = rrs::PlannerKind::look_ahead;
    rules.ramps.centripetal_share = kUnlimited;
    rules.corner_override.percent = percent;
    rules.corner_override.before_mm = before_mm;
    rules.corner_override.after_mm = after_mm;
    rules.corner_override.max_angle_deg = angle_deg;
    for (machine::Axis& axis : setup.machine.axes) {
        axis.min = -kUnlimited;
        axis.max = axis.max_acceleration = kUnlimited;
    }
    setup.machine.path.max_acceleration_mm_s2 = kUnlimited;
    return setup;
}

// Returns the time of the cut from (10, 2) on, in s, the end of the entry move.
double cut_s(const Outcome& run) {
    double sum_s = 0;
    for (std::size_t n = 2; n < run.moves.size(); ++n) sum_s += run.seconds(n);
    return run.completed() ? sum_s : std::nan("");
}

// A left turn by a right angle with the tool on the left: along y = 2 to (48, 2), then up to (48, 30).
const std::string kG62 = "G62\n";
const std::string kStart = "G0 X1 Y0\nF600 D1 G41\nG1 X10\n";
const std::string kCorner = kStart + "X50\nY30\n";

constexpr double kFeed_mm_s = 10;

TEST(CornerOverride, LowersFeedBeforeAndAfterInsideCorner) {
    const Outcome r = run(kG62 + kCorner, conditions());
    ASSERT_EQ(r.moves.size(), 6U) << r.message();
    EXPECT_NEAR(r.to(2, 'X'), 45, 1e-9);
    EXPECT_NEAR(r.to(3, 'X'), 48, 1e-9);
    EXPECT_NEAR(r.to(4, 'Y'), 7, 1e-9);
    EXPECT_NEAR(r.to(5, 'Y'), 30, 1e-9);
    const double low = kFeed_mm_s / 2;
    EXPECT_NEAR(r.seconds(2), 35 / kFeed_mm_s, 1e-9);
    EXPECT_NEAR(r.seconds(3), 3 / low, 1e-9);
    EXPECT_NEAR(r.seconds(4), 5 / low, 1e-9);
    EXPECT_NEAR(r.seconds(5), 23 / kFeed_mm_s, 1e-9);
    EXPECT_TRUE(r.report.messages.warnings.empty());
}

TEST(CornerOverride, IsSwitchedOffByOtherPathModes) {
    const double total_s = (38 + 28) / kFeed_mm_s;
    const double longer_s = total_s + 8 / kFeed_mm_s;
    EXPECT_NEAR(cut_s(run(kG62 + kCorner, conditions())), longer_s, 1e-9);
    for (const std::string mode : {"", "G62\nG61\n", "G62\nG63\n", "G62\nG64\n"})
        EXPECT_NEAR(cut_s(run(mode + kCorner, conditions())), total_s, 1e-9) << mode;
    // Each move has the mode in which it was programmed.
    EXPECT_NEAR(cut_s(run(kG62 + kStart + "X50\nG64 Y30\n", conditions())), total_s + 3 / kFeed_mm_s, 1e-9);
    EXPECT_NEAR(cut_s(run(kStart + "X50\nG62 Y30\n", conditions())), total_s + 5 / kFeed_mm_s, 1e-9);
}

TEST(CornerOverride, AppliesOnlyToInsideCornersOfCompensation) {
    const auto moves = [](const std::string& gcode) { return run(gcode, conditions()).moves.size(); };
    EXPECT_EQ(moves("G62\nF600 G1 X10\nX50\nY30\n"), 3U);                            // no compensation
    EXPECT_EQ(moves(kG62 + kStart + "X50\nY-30\n"), moves(kStart + "X50\nY-30\n"));  // outside
    EXPECT_EQ(moves("G62\nG0 X1 Y0\nF600 D3 G41\nG1 X10\nX50\nY30\n"), 4U);          // a radius of 0
    EXPECT_EQ(moves("G62\nG0 X1 Y0\nF600 D1 G41\nG1 X10\nY30\n"), 3U);               // the entry move
    EXPECT_EQ(moves(kG62 + kStart + "G0 X50\nG1 Y30\n"), 5U);  // a rapid before the corner
}

TEST(CornerOverride, AppliesOnlyToSharpCorners) {
    const std::string blunt = kG62 + kStart + "X50\nX80 Y30\n";  // 135 degrees
    EXPECT_EQ(run(blunt, conditions(50, 3, 5, 134.9)).moves.size(), 4U);
    EXPECT_EQ(run(blunt, conditions(50, 3, 5, 135.1)).moves.size(), 6U);
    EXPECT_EQ(run(kG62 + kCorner, conditions(50, 3, 5, 89.9)).moves.size(), 4U);
}

TEST(CornerOverride, SlowsShortMoveOverFullLength) {
    // From (48, 2) up to (48, 8), then back to the left: 6 mm between two corners.
    const Outcome r = run(kG62 + kStart + "X50\nY10\nX20\n", conditions());
    ASSERT_EQ(r.moves.size(), 7U) << r.message();
    EXPECT_NEAR(r.to(4, 'Y'), 8, 1e-9);
    EXPECT_NEAR(r.seconds(4), 6 / (kFeed_mm_s / 2), 1e-9);
    EXPECT_NEAR(cut_s(r), (38 + 6 + 28) / kFeed_mm_s + (3 + 6 + 5) / kFeed_mm_s, 1e-9);
}

TEST(CornerOverride, SlowsArcAfterCorner) {
    // At (30, 0) a line that runs west meets a half circle that begins to the south: the tool runs inside of
    // it, on a radius of 8 mm.
    const Outcome r = run("G62\nG0 X70 Y0\nF600 D1 G41\nG1 X60\nX30\nG3 X50 I10 J0\n", conditions(25, 0, 4));
    ASSERT_EQ(r.moves.size(), 5U) << r.message();
    const simulation::RecordedMove& slow = r.moves[3];
    ASSERT_TRUE(slow.arc && r.moves[4].arc);
    EXPECT_NEAR(slow.arc->radius_mm, 8, 1e-6);
    EXPECT_NEAR(r.moves[4].arc->radius_mm, 8, 1e-6);
    EXPECT_NEAR(slow.length_mm, 4, 1e-9);
    EXPECT_NEAR(r.seconds(3), 4 / (kFeed_mm_s / 4), 1e-9);
    EXPECT_NEAR(r.seconds(4), r.moves[4].length_mm / kFeed_mm_s, 1e-9);
    EXPECT_NEAR(r.to(4, 'X'), 48, 1e-6);
    EXPECT_NEAR(r.to(4, 'Y'), 0, 1e-6);
}

TEST(CornerOverride, OtherAxesMoveInProportion) {
    const Outcome r = run(kG62 + kStart + "X50 Z-38\nY30 Z-10\n", conditions(50, 3, 5));
    ASSERT_EQ(r.moves.size(), 6U) << r.message();
    const double share = 3 / (38 * std::sqrt(2.0));
    EXPECT_NEAR(r.to(2, 'X'), 48 - 38 * share, 1e-9);
    EXPECT_NEAR(r.to(2, 'Z'), -38 * (1 - share), 1e-9);
    EXPECT_NEAR(r.seconds(3), 3 / (kFeed_mm_s / 2), 1e-9);
    EXPECT_NEAR(r.to(5, 'Z'), -10, 1e-9);
}

TEST(CornerOverride, WarnsIfItHasNoEffect) {
    const auto warning = [](const Conditions& setup) {
        const auto warnings = run("G62\n", setup).report.messages.warnings;
        return warnings.empty() ? "" : warnings.front();
    };
    EXPECT_EQ(warning(conditions()), "");
    EXPECT_NE(warning(conditions(100)).find("corner_override_percent"), std::string::npos);
    EXPECT_NE(warning(conditions(50, 0, 0)).find("corner_override_before_mm"), std::string::npos);
    Conditions stopping = conditions();
    stopping.machine.controller.planner = rrs::PlannerKind::rest_to_rest;
    EXPECT_NE(warning(stopping).find("stops at each move"), std::string::npos);
    EXPECT_EQ(run(kG62 + kCorner, stopping).moves.size(), 4U);
}

}  // namespace
}  // namespace gsim::script::corner_override_test
