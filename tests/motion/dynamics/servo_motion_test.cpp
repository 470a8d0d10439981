// Servo loops along segments: dwells, jumps, superimposed motions, delays.
#include "motion/dynamics/servo_motion.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motion/dynamics/models.h"

namespace gsim::dynamics {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

motion::Segment path(double start_s, const rrs::JointPos& from, const rrs::JointPos& to, double speed,
                     double acceleration) {
    motion::Segment segment;
    segment.kind = motion::SegmentKind::linear;
    segment.start_s = start_s;
    segment.start = from;
    segment.end = to;
    segment.master = motion::TimeLaw::fastest((to - from).norm(), speed, acceleration);
    segment.duration_s = segment.master.duration_s();
    return segment;
}

motion::Segment standstill(double start_s, const rrs::JointPos& at, double duration_s) {
    motion::Segment segment;
    segment.start_s = start_s;
    segment.start = segment.end = at;
    segment.duration_s = duration_s;
    return segment;
}

void go(ServoMotion& servos, const motion::Segment& segment, const ServoMotion::StepHandler& on_step = {}) {
    servos.enter(segment, on_step);
    servos.leave(on_step);
}

double error(const ServoMotion& servos, double t_s, int joint = 0) {
    return servos.history().set_points(t_s)[joint] - servos.history().positions(t_s)[joint];
}

TEST(ServoMotion, ErrorAtConstantSpeedIsSpeedOverGain) {
    ServoMotion servos({{.gain_1_s = 20}}, {false});
    servos.begin(joint_pos({5}));
    go(servos, path(0, joint_pos({5}), joint_pos({105}), 50, kUnlimited));
    EXPECT_NEAR(servos.now_s(), 2, 1e-12);
    EXPECT_NEAR(error(servos, 2), 50.0 / 20 * (1 - std::exp(-40)), 1e-9);
    EXPECT_NEAR(servos.history().set_points(2)[0], 105, 1e-9);
}

// The clock continues between two segments: a dwell, in which the error decays.
TEST(ServoMotion, ErrorDecaysInGapBetweenSegments) {
    ServoMotion servos({{.gain_1_s = 20}}, {false});
    servos.begin(joint_pos({0}));
    go(servos, path(0, joint_pos({0}), joint_pos({100}), 50, kUnlimited));
    servos.go_to(2.1, {});
    EXPECT_NEAR(error(servos, 2.1), 2.5 * std::exp(-2), 1e-9);
    go(servos, standstill(2.5, joint_pos({100}), 0.5));
    EXPECT_NEAR(error(servos, 3), 2.5 * std::exp(-20), 1e-9);
}

TEST(ServoMotion, VelocityLoopLagGivesErrorOnRamp) {
    const ServoLoop loop{.gain_1_s = 50, .velocity_share = 1, .lag_s = 0.004};
    ServoMotion servos({loop}, {false});
    servos.begin(joint_pos({0}));
    const motion::Segment segment = path(0, joint_pos({0}), joint_pos({1000}), 400, 800);  // 0.5 s of ramp
    servos.enter(segment, {});
    servos.go_to(0.5, {});
    EXPECT_NEAR(error(servos, 0.5), 0.004 * 800 / 50, 1e-6);  // and no more than that of its transient
    servos.go_to(1.2, {});
    EXPECT_NEAR(error(servos, 1.2), 0, 1e-9);
    servos.leave({});
}

TEST(ServoMotion, DelayShiftsPositionInTime) {
    const ServoLoop loop{.gain_1_s = 40, .velocity_share = 0.5, .delay_s = 0.0123};
    ServoMotion servos({loop, {.gain_1_s = 40, .velocity_share = 0.5}}, {false, false});
    servos.begin(joint_pos({0, 0}));
    const motion::Segment segment = path(0, joint_pos({0, 0}), joint_pos({300, 300}), 200, 1000);
    servos.enter(segment, {});
    for (const double t_s : {0.05, 0.1234, 0.7, 1.3}) {
        servos.go_to(t_s, {});
        servos.go_to(t_s + 0.0123, {});
        EXPECT_NEAR(servos.history().positions(t_s + 0.0123)[0], servos.history().positions(t_s)[1], 1e-9)
            << t_s;
    }
    servos.leave({});
    // At a constant speed: a share of v / gain, and the delay.
    EXPECT_NEAR(loop.constant_speed_lag_s(), 0.5 / 40 + 0.0123, 1e-15);
}

// Two motions at once, as on a belt: the lag is that of their sum.
TEST(ServoMotion, StandstillOnConveyorLagsByBeltSpeed) {
    ServoMotion servos({{.gain_1_s = 25}}, {false});
    servos.begin(joint_pos({0}));
    motion::Segment segment = standstill(0, joint_pos({0}), 4);
    segment.superimposed =
        std::make_shared<const motion::Segment>(path(0, joint_pos({0}), joint_pos({400}), 100, kUnlimited));
    go(servos, segment);
    EXPECT_NEAR(error(servos, 4), 100.0 / 25, 1e-9);
    go(servos, standstill(4, joint_pos({400}), 1));
    EXPECT_NEAR(error(servos, 5), 4 * std::exp(-25), 1e-9);
}

// An axis without any limit is elsewhere at once, but still takes its time.
TEST(ServoMotion, SetPointJumpIsImmediateError) {
    ServoMotion servos({{.gain_1_s = 10}}, {false});
    servos.begin(joint_pos({0}));
    motion::Segment jump = standstill(0, joint_pos({0}), 0);
    jump.kind = motion::SegmentKind::joint;
    jump.end = joint_pos({3});
    go(servos, jump);
    go(servos, standstill(0, joint_pos({3}), 0.2));
    EXPECT_NEAR(error(servos, 0.2), 3 * std::exp(-2), 1e-12);
}

// e'' and what drives it on a circle: x = R cos wt through a lag of first order comes out smaller by
// sqrt(1 + (w/K)^2) and later by atan(w/K).
TEST(ServoMotion, LagShrinksAndDelaysCircle) {
    constexpr double kRadius_mm = 20, kSpeed_mm_s = 200, kGain_1_s = 30, kTurns = 5;
    motion::Segment segment;
    segment.kind = motion::SegmentKind::circular;
    segment.start = segment.end = joint_pos({kRadius_mm, 0, 0});
    segment.position_joints = {0, 1, 2};
    segment.arc.radius_mm = segment.arc.end_radius_mm = kRadius_mm;
    segment.arc.sweep_rad = 2 * std::numbers::pi * kTurns;
    segment.length_mm = segment.arc.length_mm();
    segment.master = motion::TimeLaw::fastest(segment.length_mm, kSpeed_mm_s, kUnlimited);
    segment.duration_s = segment.master.duration_s();
    ServoMotion servos(std::vector<ServoLoop>(3, {.gain_1_s = kGain_1_s}), {false, false, false});
    servos.begin(segment.start);
    go(servos, segment);
    const double w = kSpeed_mm_s / kRadius_mm;
    const rrs::JointPos end = servos.history().positions(servos.now_s());
    EXPECT_NEAR(std::hypot(end[0], end[1]), kRadius_mm / std::sqrt(1 + w * w / (kGain_1_s * kGain_1_s)),
                1e-9);
    EXPECT_NEAR(std::atan2(-end[1], end[0]), std::atan(w / kGain_1_s), 1e-9);
}

// Joints at a constant speed show no more change: long motions and dwells take few steps.
TEST(ServoMotion, LongMotionsTakeFewSteps) {
    ServoMotion servos({{.gain_1_s = 20, .lag_s = 0.002}}, {false});
    servos.begin(joint_pos({0}));
    int steps = 0;
    const auto count = [&](const SetPointStep&) { ++steps; };
    go(servos, path(0, joint_pos({0}), joint_pos({1e6}), 10, 100), count);
    go(servos, standstill(100'000.1, joint_pos({1e6}), 1e9), count);
    EXPECT_LT(steps, 6000);
    EXPECT_NEAR(error(servos, servos.now_s()), 0, 1e-9);
}

}  // namespace
}  // namespace gsim::dynamics
