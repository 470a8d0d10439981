#include "runtime/monitors/path_bound.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/random_program.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::path_bound_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAcceleration = 490.33;  // of the built-in machine, mm/s2
constexpr double kMaxFeed = 254;

/// Returns the min time between standstills.
double trapezoid_s(double length, double speed, double acceleration) {
    if (speed * speed > length * acceleration) return 2 * std::sqrt(length / acceleration);
    return length / speed + speed / acceleration;
}

struct Times {
    double bound_s;
    double cycle_s;
};

/// Returns the times of a program on a machine.
template <typename Program>
Times run(const machine::Machine& machine, const Program& program) {
    Simulator simulator(machine, {});
    PathBound bound(simulator.machine());
    simulator.add_output(bound);
    program(simulator);
    const Report report = simulator.finish("p");
    EXPECT_FALSE(report.alarm) << report.alarm->message;
    return {bound.bound_s(), report.cycle_time_s};
}

machine::Machine wide_af5() {
    machine::Machine machine = af5();
    for (machine::Axis& axis : machine.axes) axis.min = -1000;
    return machine;
}

machine::Machine looking_ahead(machine::Machine machine, rrs::CornerRule corner) {
    machine.controller.planner = rrs::PlannerKind::look_ahead;
    machine.controller.corners.continuous = machine.controller.corners.exact_path = corner;
    return machine;
}

AxisVector at(double x, double y, double z = 0, double b = 0, double c = 0) {
    AxisVector axes(5);
    axes << x, y, z, b, c;
    return axes;
}

LineMove to(const AxisVector& target, double feed_mm_min, MoveKind kind = MoveKind::linear) {
    return {.kind = kind, .target = target, .feed = {feed_mm_min, feed_mm_min, {}}, .location = {}};
}

ArcMove circle(double radius_mm, double feed_mm_min) {
    return {.kind = MoveKind::arc_ccw,
            .center_mm = {radius_mm, 0, 0},
            .sweep_rad = 2 * kPi,
            .target = at(0, 0),
            .feed = {feed_mm_min, 0, {}},
            .location = {}};
}

TEST(PathBound, LineBetweenStandstillsTakesItsBound) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> mm(-300, 300), decades(0, 5);
    const machine::Machine machine = wide_af5();
    for (int i = 0; i < 300; ++i) {
        const double feed = std::pow(10, decades(random));
        const AxisVector target = at(mm(random), mm(random), mm(random));
        const MoveKind kind = i % 2 == 0 ? MoveKind::linear : MoveKind::rapid;
        const Times times = run(machine, [&](Simulator& s) { s.moves().enqueue(to(target, feed, kind)); });
        EXPECT_NEAR(times.bound_s, times.cycle_s, 1e-9 * times.cycle_s) << target.transpose();
    }
}

TEST(PathBound, CornersCostNothing) {
    const Times times = run(af5(), [](Simulator& s) {
        for (const AxisVector& target : {at(100, 0), at(100, 80), at(30, 80)})
            s.moves().enqueue(to(target, 6000));
    });
    EXPECT_NEAR(times.bound_s, trapezoid_s(100 + 80 + 70, 100, kAcceleration), 1e-9);
    EXPECT_GT(times.cycle_s, times.bound_s);
}

TEST(PathBound, ContinuousControllerTakesBoundOnLine) {
    const auto machine = looking_ahead(af5(), rrs::CornerRule::velocity_step);
    const Times times = run(machine, [](Simulator& s) {
        s.program().settings().set_path_mode(rrs::PathMode::continuous, 0, 0);
        for (int i = 1; i <= 50; ++i) s.moves().enqueue(to(at(7 * i, 9 * i), i < 25 ? 3000 : 9000));
    });
    EXPECT_NEAR(times.bound_s, times.cycle_s, 1e-9);
}

TEST(PathBound, DwellAddsItsTimeAtStandstill) {
    const Times times = run(af5(), [](Simulator& s) {
        s.moves().enqueue(to(at(100, 0), 6000));
        s.dwells().enqueue(2.5, {});
        s.moves().enqueue(to(at(200, 0), 6000));
    });
    EXPECT_NEAR(times.bound_s, 2.5 + 2 * trapezoid_s(100, 100, kAcceleration), 1e-9);
    EXPECT_NEAR(times.bound_s, times.cycle_s, 1e-9);
}

TEST(PathBound, ExcludesStandstillOfController) {
    machine::Machine machine = looking_ahead(af5(), rrs::CornerRule::stop);
    machine.controller.position_loop.settle_s = 3;
    const Times times = run(machine, [](Simulator& s) {
        s.program().settings().set_path_mode(rrs::PathMode::exact_stop, 0, 0);
        s.moves().enqueue(to(at(100, 0), 6000));
    });
    EXPECT_NEAR(times.bound_s, trapezoid_s(100, 100, kAcceleration), 1e-9);
    EXPECT_NEAR(times.cycle_s, times.bound_s + 3, 1e-9);
}

TEST(PathBound, RotaryMovesCountInDegrees) {
    const Times times = run(af5(), [](Simulator& s) { s.moves().enqueue(to(at(0, 0, 0, 90, 0), 600)); });
    EXPECT_NEAR(times.bound_s, trapezoid_s(90, 10, 20), 1e-9);
    machine::Machine slow = af5();
    slow.path.max_feed_mm_s = 1e-3;
    const Times same = run(slow, [](Simulator& s) { s.moves().enqueue(to(at(0, 0, 0, 90, 0), 600)); });
    EXPECT_NEAR(same.bound_s, times.bound_s, 1e-9);
}

TEST(PathBound, IgnoresProgrammedTime) {
    LineMove move = to(at(100, 0), 0);
    move.feed = {0, 0, 10.0};
    const Times times = run(af5(), [&](Simulator& s) { s.moves().enqueue(move); });
    EXPECT_NEAR(times.cycle_s, 10, 1e-9);
    EXPECT_NEAR(times.bound_s, trapezoid_s(100, kMaxFeed, kAcceleration), 1e-9);
}

// 10 mm and 90 deg: the rotary axis, which moves by its own law, takes 4.24 s.
TEST(PathBound, IgnoresFollowerJoints) {
    machine::Machine machine = af5();
    machine.controller.coordination.independent_ramps = true;
    const Times times = run(machine, [](Simulator& s) { s.moves().enqueue(to(at(10, 0, 0, 90), 6000)); });
    EXPECT_NEAR(times.bound_s, trapezoid_s(10, 100, kAcceleration), 1e-9);
    EXPECT_GT(times.cycle_s, 4);
}

TEST(PathBound, ProportionalJointsCount) {
    for (const auto& machine : {af5(), looking_ahead(af5(), rrs::CornerRule::stop)}) {
        const Times times = run(machine, [](Simulator& s) { s.moves().enqueue(to(at(10, 0, 0, 90), 6000)); });
        EXPECT_NEAR(times.bound_s, trapezoid_s(90, 90, 20), 1e-9);
        EXPECT_NEAR(times.bound_s, times.cycle_s, 1e-9);
    }
}

// Towards the centre and along the path together, two joints have no more than sqrt(2) of what one has.
TEST(PathBound, ArcWithinLimitsCountsByShape) {
    constexpr double kRadius_mm = 20;
    const double fastest = std::sqrt(std::sqrt(2.0) * kAcceleration * kRadius_mm);
    const double min_s = 2 * kPi * kRadius_mm / fastest;
    const auto machine = looking_ahead(wide_af5(), rrs::CornerRule::stop);
    const auto program = [](Simulator& s) { s.moves().enqueue(circle(kRadius_mm, 60 * kMaxFeed)); };
    const Times kept = run(machine, program);
    EXPECT_GT(kept.bound_s, min_s);
    EXPECT_LT(kept.bound_s, kept.cycle_s);
    EXPECT_GT(kept.bound_s, 0.8 * kept.cycle_s);
    const Times passed = run(wide_af5(), program);  // its planner does not slow down for curves
    EXPECT_LT(passed.cycle_s, min_s);
    EXPECT_LE(passed.bound_s, passed.cycle_s);
    EXPECT_GE(passed.bound_s, 2 * kPi * kRadius_mm / kMaxFeed);
}

TEST(PathBound, IgnoresSuperimposedMotions) {
    const machine::Machine machine = af5();
    const MoveInfo info{.kind = MoveKind::linear, .feed_per_min = 60 * kSpeed_mm_s};
    const auto bound_s = [&](bool with_blend) {
        PathBound bound(machine);
        motion::Segment first = line(1, 0, joints(0, 0), joints(100, 0));
        bound.on_segment(first, info);
        if (with_blend) {
            motion::Segment blend = line(1, 2.5, joints(100, 0), joints(200, 0));
            blend.superimposed =
                std::make_shared<motion::Segment>(line(2, 2.5, joints(0, 0), joints(0, 100)));
            bound.on_segment(blend, info);
        }
        return bound.bound_s();
    };
    const double ramp_s = kSpeed_mm_s / kAcceleration;
    EXPECT_NEAR(bound_s(false), trapezoid_s(100, kSpeed_mm_s, kAcceleration), 1e-9);
    // The blend may begin at any speed, so one ramp less.
    EXPECT_NEAR(bound_s(true), 100 / kSpeed_mm_s + ramp_s / 2, 1e-9);
}

TEST(PathBound, FeedOverrideCounts) {
    const Times times = run(af5(), [](Simulator& s) {
        s.services().shell().SetOverrideSpeed(150);
        s.moves().enqueue(to(at(200, 0), 6000));
    });
    EXPECT_NEAR(times.bound_s, times.cycle_s, 1e-9);
    EXPECT_NEAR(times.cycle_s, trapezoid_s(200, 150, kAcceleration), 1e-9);
}

TEST(PathBound, HoldsWithoutLimitsAndWithoutMotion) {
    const Times none = run(af5(), [](Simulator&) {});
    EXPECT_EQ(none.bound_s, 0);
    machine::Machine machine = unlimited(af5());
    const Times times = run(machine, [](Simulator& s) {
        s.moves().enqueue(to(at(100, 0), 6000));
        s.moves().enqueue(circle_at(s, 10, 6000));
    });
    EXPECT_NEAR(times.bound_s, (100 + 20 * kPi) / 100, 1e-6);
    EXPECT_NEAR(times.cycle_s, times.bound_s, 1e-6);
}

TEST(PathBound, NeverExceedsCycleTimeOnGreatCircles) {
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        machine::Machine machine = random_machine(random, af5());
        if (i % 2 == 0) machine = looking_ahead(machine, rrs::CornerRule::velocity_step);
        machine.controller.coordination.orientation = rrs::OrientationRule::great_circle;
        const Times times = run(machine, [&](Simulator& s) {
            s.moves().enqueue(to(at(0, 0, 0, 0, 10), 3000));
            for (int k = 0; k < 20; ++k) {
                AxisVector target = at(between(random, 0, 200), between(random, 0, 200), 0,
                                       between(random, -80, 80), between(random, 5, 85));
                if (k % 3 == 0) target.head<3>() = s.position().axes().head<3>();
                s.moves().enqueue(to(target, 3000, k % 5 == 0 ? MoveKind::rapid : MoveKind::linear));
            }
        });
        EXPECT_LE(times.bound_s, times.cycle_s * (1 + 1e-9)) << i;
        EXPECT_GT(times.bound_s, 0) << i;
    }
}

struct Controller {
    const char* name;
    rrs::PlannerKind planner;
    rrs::CornerRule corner;
    bool limit_jerk;
    double chord_tolerance_mm;
};

class PathBoundOfController : public testing::TestWithParam<Controller> {};

TEST_P(PathBoundOfController, NeverExceedsCycleTimeOfRandomProgram) {
    std::mt19937 random(7);
    double closest = 0;
    for (int i = 0; i < 60; ++i) {
        machine::Machine machine = random_machine(random, af5());
        machine.controller.planner = GetParam().planner;
        machine.controller.corners.continuous = machine.controller.corners.exact_path = GetParam().corner;
        machine.controller.ramps.limit_jerk = GetParam().limit_jerk;
        machine.controller.curves.arc_chord_tolerance_mm = GetParam().chord_tolerance_mm;
        machine.controller.blocks.look_ahead = 1 + random() % 30;
        machine.controller.corners.stop_between_rapid_and_feed = random() % 2 == 0;
        machine.controller.ramps.centripetal_share = random() % 4 == 0 ? motion::kUnlimited : 0.866;
        const Times times = run(machine, [&](Simulator& s) { make_random_moves(random, s, 25); });
        EXPECT_LE(times.bound_s, times.cycle_s * (1 + 1e-9)) << i;
        EXPECT_GT(times.bound_s, 0) << i;
        closest = std::max(closest, times.bound_s / times.cycle_s);
    }
    EXPECT_GT(closest, 0.5);
}

using rrs::CornerRule;
using rrs::PlannerKind;

INSTANTIATE_TEST_SUITE_P(
    Controllers, PathBoundOfController,
    testing::Values(
        Controller{"ExactStop", PlannerKind::rest_to_rest, CornerRule::stop, false, 0},
        Controller{"VelocityStep", PlannerKind::look_ahead, CornerRule::velocity_step, false, 0},
        Controller{"VelocityStepWithJerk", PlannerKind::look_ahead, CornerRule::velocity_step, true, 0},
        Controller{"JunctionDeviation", PlannerKind::look_ahead, CornerRule::junction_deviation, false, 0},
        Controller{"Chords", PlannerKind::look_ahead, CornerRule::junction_deviation, false, 0.01}),
    [](const auto& controller) { return controller.param.name; });

}  // namespace
}  // namespace gsim::simulation::path_bound_test
