// Look-ahead of Klipper against closed forms.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/motion/klipper/klipper_path.h"

namespace gsim::motion::klipper_test {
namespace {

constexpr double kEqualTolerance = 1e-9;

TEST(Klipper, LongLineIsTrapezoid) {
    KlipperPath path;
    path.line(rrs::JointPos(Eigen::Vector3d(100, 0, 0)), 200);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 100.0 / 100 + 100.0 / 1000, kEqualTolerance);
    EXPECT_EQ(path.segments().front().limited_by.kind, LimitKind::path_speed);
}

TEST(Klipper, DiagonalIsNoFasterThanXAxis) {
    KlipperPath path;
    path.line(80, 60);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 1.1, kEqualTolerance);
}

TEST(Klipper, ZAxisLimitsPathByItsShare) {
    KlipperPath ascent;
    ascent.line(0, 0, 20);
    ascent.line(0, 0, 0);
    ascent.standstill();
    EXPECT_NEAR(ascent.time_s(), 2 * (20.0 / 20 + 20.0 / 200), kEqualTolerance);
    KlipperPath slope;
    slope.line(40, 0, 30);  // L/|dz| = 5/3
    slope.standstill();
    const double v = 20 * 5 / 3.0, a = 200 * 5 / 3.0;
    EXPECT_NEAR(slope.time_s(), 50 / v + v / a, kEqualTolerance);
}

TEST(Klipper, ShortMoveCruisesOverMinimumRatio) {
    KlipperPath path;
    path.line(3, 0);
    path.standstill();
    const double peak = std::sqrt(3 * 1000 * 0.5);  // 38.73 mm/s
    EXPECT_NEAR(path.segments().front().master.peak_speed(), peak, kEqualTolerance);
    EXPECT_NEAR(path.time_s(), 3 * peak / 1000, kEqualTolerance);  // each third of it 0.03873 s
    EXPECT_NEAR(path.time_s(), 0.1161895, 1e-7);
}

TEST(Klipper, ShortMoveIsTriangleWithoutCruiseRatio) {
    KlipperPath path;
    path.setup().controller.klipper.minimum_cruise_ratio = 0;
    path.line(3, 0);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 2 * std::sqrt(3.0 / 1000), kEqualTolerance);
}

TEST(Klipper, CruiseRatioSpansSeveralMoves) {
    KlipperPath path;
    for (const double x : {1.0, 2.0, 3.0}) path.line(x, 0);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 0.1161895, 1e-7);  // as the one move of 3 mm
}

TEST(Klipper, PassesRightAngleAtSquareCornerVelocity) {
    KlipperPath path;
    path.line(50, 0);
    path.line(50, 50);
    path.standstill();
    EXPECT_NEAR(path.segments()[0].master.end_speed(), 5, kEqualTolerance);
    EXPECT_EQ(path.segments()[0].master.end_speed(), path.segments()[1].master.start_speed());
}

TEST(Klipper, StopsAtReversalButNotAtStraightJunction) {
    KlipperPath back;
    back.line(50, 0);
    back.line(0, 0);
    back.standstill();
    EXPECT_NEAR(back.time_s(), 2 * (0.5 + 0.1), kEqualTolerance);
    KlipperPath on;
    on.line(50, 0);
    on.line(100, 0);
    on.standstill();
    EXPECT_NEAR(on.time_s(), 1.1, kEqualTolerance);
}

// The circle that fits into chords of 0.1 mm touches them in their middles.
TEST(Klipper, InscribedCircleLimitsSpeedOfShortChords) {
    KlipperPath path;
    const double turn = 0.2, chord = 0.1;
    double x = 0, y = 0;
    for (int i = 0; i < 100; ++i) path.line(x += chord * std::cos(i * turn), y += chord * std::sin(i * turn));
    path.standstill();
    const double tangent = 1 / std::tan(turn / 2);  // of half the angle between the chords
    const double speed = std::sqrt(2 * chord * 1000 * 0.25 * tangent);
    EXPECT_NEAR(path.segments()[50].master.start_speed(), speed, 1e-6);
}

TEST(Klipper, ResolutionSetsChordCountOfArc) {
    KlipperPath path;
    ASSERT_TRUE(path.arc(2, kPi));  // 6.28 mm
    ASSERT_TRUE(path.arc(0.1, 1));
    path.standstill();
    EXPECT_EQ(path.segments().size(), 6u + 1u);
    EXPECT_FALSE(path.segments()[0].reaches_target);
    EXPECT_TRUE(path.segments()[5].reaches_target);
    KlipperPath none;
    none.setup().controller.klipper.arc_resolution_mm = 0;
    const PlanResult rejected = none.arc(2, kPi);
    ASSERT_FALSE(rejected);
    EXPECT_EQ(rejected.error().status, rrs::Status::RRS_MOTION_TYPE_NOT_SUPPORTED);
}

TEST(Klipper, RapidsKeepPathLimits) {
    KlipperPath path;
    path.rapid = true;
    path.line(100, 0);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 1.1, kEqualTolerance);
}

TEST(Klipper, StopsAtExactStop) {
    KlipperPath path;
    path.mode = rrs::PathMode::exact_stop;
    path.line(50, 0);
    path.line(100, 0);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 2 * 0.6, kEqualTolerance);
}

TEST(Klipper, LaterLimitsLeaveEarlierMovesUnchanged) {
    KlipperPath path;
    path.line(100, 0);
    path.setup().path.max_acceleration_mm_s2 = 500;
    path.line(200, 0);
    path.standstill();
    EXPECT_NEAR(path.time_s(), 2 + 0.05 + 0.1, kEqualTolerance);
}

TEST(Klipper, RejectsMoveWithoutLimits) {
    KlipperPath path;
    path.setup().path = {};
    const PlanResult rejected = path.enqueue(rrs::JointPos::Unit(3, 0));
    ASSERT_FALSE(rejected);
    EXPECT_EQ(rejected.error().status, rrs::Status::RRS_ZERO_SPEED);
    EXPECT_TRUE(path.enqueue(rrs::JointPos::Unit(3, 2)));
}

rrs::JointPos at(double x, double e, double z = 0) {
    rrs::JointPos joints(4);
    joints << x, 0, z, e;
    return joints;
}

TEST(KlipperExtruder, KeepsOwnLimitsAndStopsToolIfMovingAlone) {
    KlipperPath path{printer_setup()};
    path.line(at(50, 0));
    path.line(at(50, -20), 200);
    path.line(at(100, -20));
    path.standstill();
    EXPECT_NEAR(path.time_s(), 2 * (0.5 + 0.1) + 20.0 / 80 + 80.0 / 800, kEqualTolerance);
}

TEST(KlipperExtruder, ExtrusionAlongPathDoesNotSlowTool) {
    KlipperPath path{printer_setup()};
    path.line(at(100, 100));
    path.standstill();
    EXPECT_NEAR(path.time_s(), 1.1, kEqualTolerance);
}

TEST(KlipperExtruder, RetractionAlongPathSlowsTool) {
    KlipperPath path{printer_setup()};
    path.line(at(100, -200));
    path.standstill();
    EXPECT_NEAR(path.time_s(), 100.0 / 40 + 40.0 / 400, kEqualTolerance);
}

TEST(KlipperExtruder, ExtrusionDuringZMoveSlowsTool) {
    KlipperPath path{printer_setup()};
    path.line(at(0, 20, 2));  // E: 8 mm/s along the path; Z: 20
    path.standstill();
    const double v = 8, a = 80;
    EXPECT_NEAR(path.time_s(), 2 / v + v / a, kEqualTolerance);
}

TEST(KlipperExtruder, ExtrusionRateChangeLimitsJunctionSpeed) {
    KlipperPath path{printer_setup()};
    path.line(at(50, 5));     // 0.1 mm each mm
    path.line(at(100, 5.5));  // 0.01
    path.standstill();
    EXPECT_NEAR(path.segments()[0].master.end_speed(), 1 / 0.09, 1e-6);
}

}  // namespace
}  // namespace gsim::motion::klipper_test
