// The operator's overrides: what they make of the time of moves, when a change acts, and what they leave as
// it is, with each of the planners.

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/machines.h"
#include "tests/motion/motion_checks.h"

namespace gsim::motion {
namespace {

constexpr double kAcceleration = 1000;  // mm/s2, of three_slide_machine()

enum class Planner { standstill, look_ahead, linuxcnc };

PlannerSetup make_setup(Planner planner) {
    PlannerSetup setup = three_slide_machine();
    rrs::ControllerRules& rules = setup.controller;
    if (planner == Planner::standstill) return setup;
    rules.planner = planner == Planner::linuxcnc ? rrs::PlannerKind::linuxcnc : rrs::PlannerKind::look_ahead;
    rules.blocks.look_ahead = 15;
    rules.corners.continuous = rules.corners.exact_path = rrs::CornerRule::junction_deviation;
    rules.corners.stop_between_rapid_and_feed = planner == Planner::linuxcnc;
    return setup;
}

class Segments final : public SegmentSink {
  public:
    void on_segment(const Segment& segment) override { all.push_back(segment); }
    std::vector<Segment> all;
};

/// Lines in the XY plane, planned under overrides.
class Operated {
  public:
    explicit Operated(const PlannerSetup& setup, std::vector<OverrideChange> changes = {})
        : planner_(setup, &sink_) {
        if (!changes.empty())
            planner_.machine().set_overrides(std::make_shared<const OverrideSchedule>(std::move(changes)));
        planner_.Initialize();
        planner_.SetInitialPosition(rrs::CartPos::Identity(), joint_pos({0, 0, 0}), {});
        planner_.SelectMotionType(rrs::MotionType::linear);
        planner_.SetPathMode(rrs::PathMode::exact_path, 0, 0);
    }

    void feed(double x, double y, double speed_mm_s) {
        planner_.SetRapid(false);
        planner_.SetCartesianPositionSpeed(speed_mm_s);
        go(x, y);
    }
    void rapid(double x, double y) {
        planner_.SetRapid(true);
        go(x, y);
    }
    void arc(double center_x, double center_y, double sweep_rad, double x, double y, double speed_mm_s) {
        planner_.SetRapid(false);
        planner_.SetCartesianPositionSpeed(speed_mm_s);
        EXPECT_EQ(planner_.SetNextArcTarget(++id_, {center_x, center_y, 0}, Eigen::Vector3d::UnitZ(),
                                            sweep_rad, rrs::CartPos::Identity(), joint_pos({x, y, 0})),
                  rrs::Status::RRS_SUCCESS);
    }
    void set_enabled_overrides(const EnabledOverrides& enabled_overrides) {
        planner_.set_enabled_overrides(enabled_overrides);
    }
    DefaultPlanner& planner() { return planner_; }
    /// Ends the program and returns its time.
    double end() {
        planner_.flush();
        return planner_.time_s();
    }
    const std::vector<Segment>& segments() const { return sink_.all; }
    double length_mm() const {
        double sum = 0;
        for (const Segment& segment : segments()) sum += segment.length_mm;
        return sum;
    }

  private:
    void go(double x, double y) {
        EXPECT_EQ(planner_.SetNextTarget(++id_, rrs::TargetParam::end, rrs::CartPos::Identity(),
                                         joint_pos({x, y, 0}), {}, 0),
                  rrs::Status::RRS_SUCCESS);
    }

    Segments sink_;
    DefaultPlanner planner_;
    rrs::TargetId id_ = 0;
};

std::vector<OverrideChange> constant(const Overrides& overrides) {
    return {{0, overrides}};
}

double trapezoid_s(double length, double speed) {
    return length / speed + speed / kAcceleration;
}

class PlannerOverrides : public testing::TestWithParam<Planner> {
  protected:
    PlannerSetup setup() const { return make_setup(GetParam()); }
};

TEST_P(PlannerOverrides, FeedTakesTimeOfOverriddenSpeed) {
    for (const double share : {0.1, 0.5, 0.8, 1.2, 2.0}) {
        Operated run(setup(), constant({.feed = share}));
        run.feed(100, 0, 10);
        EXPECT_NEAR(run.end(), trapezoid_s(100, 10 * share), 1e-9) << share;
    }
}

TEST_P(PlannerOverrides, FeedNeverExceedsJointLimits) {
    Operated run(setup(), constant({.feed = 2}));
    run.feed(100, 0, 80);
    EXPECT_NEAR(run.end(), trapezoid_s(100, 100), 1e-9);
}

TEST_P(PlannerOverrides, RapidScalesSpeedButNotAcceleration) {
    Operated run(setup(), constant({.feed = 0.5, .rapid = 0.25}));
    run.rapid(100, 0);
    EXPECT_NEAR(run.end(), trapezoid_s(100, 25), 1e-9);
    EXPECT_EQ(run.segments().front().limited_by.kind, LimitKind::rapid_override);
}

TEST_P(PlannerOverrides, LockedMoveIgnoresOverrides) {
    Operated run(setup(), constant({.feed = 0.5, .rapid = 0.5, .spindle = 0.5}));
    run.set_enabled_overrides({.feed = false, .rapid = false});
    run.feed(100, 0, 10);
    run.planner().dwells().plan_to_standstill();
    const double feed_s = run.planner().time_s();
    EXPECT_NEAR(feed_s, trapezoid_s(100, 10), 1e-9);
    run.rapid(0, 0);
    EXPECT_NEAR(run.end() - feed_s, trapezoid_s(100, 100), 1e-9);
}

TEST_P(PlannerOverrides, LockAppliesToItsTargetOnly) {
    Operated run(setup(), constant({.feed = 0.5}));
    run.set_enabled_overrides({.feed = false});
    run.feed(100, 0, 10);
    run.set_enabled_overrides({});
    run.feed(100, 50, 10);
    double locked_s = 0;
    run.end();
    for (const Segment& segment : run.segments()) {
        const double peak = segment.master.peak_speed();
        EXPECT_NEAR(peak, segment.target_id == 1 ? 10 : 5, 1e-9);
        if (segment.target_id == 1) locked_s += segment.duration_s;
    }
    EXPECT_NEAR(locked_s, 100 / 10.0, 0.03);
}

TEST_P(PlannerOverrides, FeedAndSpindleOverridesMultiply) {
    Operated run(setup(), constant({.feed = 0.5, .spindle = 1.5}));
    run.set_enabled_overrides({.spindle = true});
    run.feed(100, 0, 10);
    EXPECT_NEAR(run.end(), trapezoid_s(100, 7.5), 1e-9);
}

// The slowdown from 50 to 25 mm/s takes 0.025 s and 0.9375 mm.
TEST_P(PlannerOverrides, ChangeActsOnCurrentMove) {
    Operated slower(setup(), {{1, {.feed = 0.5}}});
    slower.feed(100, 0, 50);
    const double rest_mm = 100 - (50 - 1.25) - 0.9375 - 0.3125;
    EXPECT_NEAR(slower.end(), 1 + 0.025 + rest_mm / 25 + 0.025, 1.001e-3);
    EXPECT_NEAR(slower.length_mm(), 100, 1e-9);

    Operated faster(setup(), {{1, {.feed = 2}}});
    faster.feed(100, 0, 50);
    const double distance_mm = 100 - (50 - 1.25) - 3.75 - 5;
    EXPECT_NEAR(faster.end(), 1 + 0.05 + distance_mm / 100 + 0.1, 1.001e-3);
}

TEST_P(PlannerOverrides, FeedHoldBrakesAndWaits) {
    Operated run(setup(), {{1, {.feed = 0}}, {3, {.feed = 1}}});
    run.feed(100, 0, 50);
    const double rest_mm = 100 - (50 - 1.25) - 1.25;
    EXPECT_NEAR(run.end(), 3 + trapezoid_s(rest_mm, 50), 1.001e-3);
    const auto is_at_standstill = [](const Segment& segment) {
        return (segment.position_at(0.5 * segment.duration_s) - segment.start).norm() < 1e-12;
    };
    EXPECT_FALSE(std::all_of(run.segments().begin(), run.segments().end(), is_at_standstill));
    EXPECT_NEAR(run.length_mm(), 100, 1e-9);
}

TEST_P(PlannerOverrides, MoveWaitsIfStartedDuringHold) {
    Operated run(setup(), {{0, {.feed = 0}}, {2, {.feed = 0.5}}});
    run.feed(100, 0, 50);
    EXPECT_NEAR(run.end(), 2 + trapezoid_s(100, 25), 1.001e-3);
}

TEST_P(PlannerOverrides, FeedOverrideDoesNotAffectRapid) {
    Operated run(setup(), {{0.3, {.feed = 0.5}}});
    run.rapid(100, 0);
    EXPECT_NEAR(run.end(), trapezoid_s(100, 100), 1e-9);
}

TEST_P(PlannerOverrides, ArcStaysOnCircle) {
    PlannerSetup slides = setup();
    slides.controller.ramps.centripetal_share = 0.5;
    Operated run(slides, {{1, {.feed = 0.5}}, {2, {.feed = 0.8}}});
    run.arc(-20, 0, kPi, -40, 0, 20);
    run.end();
    ASSERT_GE(run.segments().size(), 3U);
    for (const Segment& segment : run.segments()) {
        for (int i = 0; i <= 8; ++i) {
            const rrs::JointPos at = segment.position_at(segment.duration_s * i / 8);
            EXPECT_NEAR(std::hypot(at[0] + 20, at[1]), 20, 1e-9);
        }
    }
    EXPECT_NEAR(run.length_mm(), 20 * kPi, 1e-9);
}

/// Lines and rapids at random: the same for each seed.
void random_program(unsigned seed, Operated& run) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-30, 30), speed(5, 90), kind(0, 1);
    double x = 0, y = 0;
    for (int i = 0; i < 40; ++i) {
        const double size = kind(random) < 0.5 ? 0.05 : 1;
        const double dx = coordinate(random);
        const double dy = coordinate(random);
        x += size * dx;
        y += size * dy;
        const double f = speed(random);
        if (kind(random) < 0.2) {
            run.rapid(x, y);
        } else {
            run.feed(x, y, f);
        }
    }
}

std::vector<OverrideChange> random_changes(unsigned seed, bool with_hold) {
    std::mt19937 random(seed + 1000);
    std::uniform_real_distribution<double> share(0.1, 2), after(0.001, 0.8), kind(0, 1);
    std::vector<OverrideChange> changes;
    double at_s = 0;
    for (int i = 0; i < 60; ++i) {
        at_s += after(random);
        const double feed = share(random);
        const double rapid = share(random);
        const bool hold = with_hold && kind(random) < 0.2;
        changes.push_back({at_s, {hold ? 0 : feed, hold ? 0 : std::min(rapid, 1.0)}});
    }
    changes.push_back({at_s + 1, {}});
    return changes;
}

TEST_P(PlannerOverrides, ChangesKeepPathAndLimits) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        Operated plain(setup());
        random_program(seed, plain);
        plain.end();
        Operated turned(setup(), random_changes(seed, seed % 2 == 1));
        random_program(seed, turned);
        turned.end();
        EXPECT_NEAR(turned.length_mm(), plain.length_mm(), 1e-6) << seed;
        double end_s = 0;
        rrs::JointPos at = joint_pos({0, 0, 0});
        double speed = 0;
        for (const Segment& segment : turned.segments()) {
            ASSERT_NEAR(segment.start_s, end_s, 1e-9) << seed;
            ASSERT_NEAR((segment.start - at).norm(), 0, 1e-6) << seed;
            end_s = segment.end_s();
            at = segment.end_position();
            if (segment.kind == SegmentKind::rest || segment.superimposed) continue;
            ASSERT_LE(segment.master.peak_acceleration(),
                      segment.master_limits.acceleration * (1 + 1e-6) + 1e-6)
                << seed;
            // Along the path the speed does not jump, whatever the corners do to the directions.
            ASSERT_NEAR(segment.master.start_speed(), speed, 1e-3) << seed;
            speed = segment.master.end_speed();
        }
        EXPECT_NEAR((at - plain.segments().back().end_position()).norm(), 0, 1e-6) << seed;
    }
}

TEST_P(PlannerOverrides, LowerOverrideIsNeverFaster) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        double before_s = 0;
        for (const double share : {1.0, 0.7, 0.35, 0.2}) {
            Operated run(setup(), constant({.feed = share, .rapid = share}));
            random_program(seed, run);
            const double now_s = run.end();
            EXPECT_GE(now_s, before_s - (GetParam() == Planner::linuxcnc ? 0.05 : 1e-9)) << seed;
            before_s = now_s;
        }
    }
}

TEST_P(PlannerOverrides, OneHundredPercentChangesNothing) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        Operated plain(setup()), turned(setup(), {{0.5, {}}, {1, {}}});
        random_program(seed, plain);
        random_program(seed, turned);
        EXPECT_NEAR(plain.end(), turned.end(), 1e-6);
    }
}

std::string planner_name(const testing::TestParamInfo<Planner>& tested) {
    switch (tested.param) {
        case Planner::standstill: return "rest";
        case Planner::look_ahead: return "look_ahead";
        case Planner::linuxcnc: break;
    }
    return "linuxcnc";
}

INSTANTIATE_TEST_SUITE_P(Planners, PlannerOverrides,
                         testing::Values(Planner::standstill, Planner::look_ahead, Planner::linuxcnc),
                         planner_name);

// Corners that are rounded keep all limits of the joints, whatever the operator does before them.
TEST(Overrides, RoundedCornersKeepLimits) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        PlannerSetup setup = make_setup(Planner::look_ahead);
        setup.controller.corners.continuous = setup.controller.corners.exact_path =
            rrs::CornerRule::parabolic_blend;
        setup.controller.corners.stop_between_rapid_and_feed = true;
        Operated run(setup, random_changes(seed, seed % 2 == 1));
        random_program(seed, run);
        run.end();
        rrs::JointPos at = joint_pos({0, 0, 0});
        for (const Segment& segment : run.segments()) {
            ASSERT_NEAR((segment.position_at(0) - at).norm(), 0, 1e-6) << seed;
            at = segment.end_position();
            const double rounding = 1e-6 + 1e-9 / segment.master.length();  // of the ends of a short path
            for (int i = 0; i <= 20; ++i) {
                const JointState state = segment.at(segment.duration_s * i / 20);
                for (int joint = 0; joint < 3; ++joint) {
                    ASSERT_LE(std::abs(state.velocity[joint]), 100 * (1 + 1e-6)) << seed;
                    ASSERT_LE(std::abs(state.acceleration[joint]), kAcceleration * (1 + rounding)) << seed;
                }
            }
        }
    }
}

// The operator changes the overrides of an S-curve at points without acceleration.
TEST(Overrides, SCurveChangesWithoutAccelerationJump) {
    for (const Planner planner : {Planner::standstill, Planner::look_ahead}) {
        PlannerSetup setup = make_setup(planner);
        setup.controller.ramps.limit_jerk = true;
        for (JointSetup& joint : setup.joints) joint.max_jerk = 20'000;
        Operated run(setup,
                     {{0.02, {.feed = 0.5}}, {1, {.feed = 1.5}}, {1.2, {.feed = 0}}, {2, {.feed = 1}}});
        run.feed(100, 0, 50);
        run.end();
        double acceleration = 0;
        for (const Segment& segment : run.segments()) {
            if (segment.kind == SegmentKind::rest) continue;
            EXPECT_NEAR(segment.master.at(0).a, acceleration, 1e-6);
            acceleration = segment.master.at(segment.duration_s).a;
            expect_law_limits(segment.master, segment.master_limits);
        }
        EXPECT_NEAR(run.length_mm(), 100, 1e-9);
        EXPECT_GE(run.segments().size(), 4U);
    }
}

TEST(Overrides, ScaleJointMotionAndMotionTime) {
    Operated run(make_setup(Planner::standstill), constant({.feed = 0.5}));
    run.planner().SelectMotionType(rrs::MotionType::joint);
    run.planner().SetNextTarget(1, rrs::TargetParam::end, rrs::CartPos::Identity(), joint_pos({100, 0, 0}),
                                {}, 0);
    EXPECT_NEAR(run.end(), trapezoid_s(100, 50), 1e-9);
    run.planner().SelectMotionType(rrs::MotionType::linear);
    run.planner().SetCartesianPositionSpeed(kUnlimited);
    run.planner().SetMotionTime(4);
    const double start_s = run.planner().time_s();
    EXPECT_EQ(run.planner().SetNextTarget(2, rrs::TargetParam::end, rrs::CartPos::Identity(),
                                          joint_pos({0, 0, 0}), {}, 0),
              rrs::Status::RRS_SUCCESS)
        << "the time that is asked for is twice as long now";
    EXPECT_NEAR(run.end() - start_s, 8, 1e-9);
}

TEST(Overrides, ServiceAndOperatorOverridesMultiply) {
    Operated run(make_setup(Planner::standstill), constant({.feed = 0.5}));
    run.planner().SetOverrideSpeed(50);
    run.feed(100, 0, 40);
    EXPECT_NEAR(run.end(), trapezoid_s(100, 10), 1e-9);
}

}  // namespace
}  // namespace gsim::motion
