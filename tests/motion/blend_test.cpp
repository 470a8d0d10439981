// Corners rounded within a tolerance: how far, how fast, and that no limit is exceeded on the path.
#include "motion/lookahead/blend.h"

#include <algorithm>

#include "tests/motion/look_ahead_path.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::blend_test {
namespace {

using rrs::CornerRule;

PlannerSetup blend_setup(CornerRule rule) {
    PlannerSetup setup = router_setup();
    setup.controller.corners.continuous = rule;
    setup.controller.corners.exact_path = CornerRule::stop;
    setup.controller.ramps.centripetal_share = 0.866;
    setup.controller.ramps.limit_jerk = rule == CornerRule::smooth_blend;
    for (JointSetup& joint : setup.joints) joint.max_jerk = 2e4;
    return setup;
}

/// Three linear and two rotary joints with random limits.
PlannerSetup random_setup(std::mt19937& random, CornerRule rule) {
    std::uniform_real_distribution<double> log_scale(-1, 1);
    PlannerSetup setup = blend_setup(rule);
    setup.joints.resize(5, {rrs::JointKind::revolute});
    for (JointSetup& joint : setup.joints) {
        const double unit = joint.kind == rrs::JointKind::revolute ? 0.02 : 1;
        joint.max_speed = 200 * unit * std::exp(log_scale(random));
        joint.max_acceleration = 1000 * unit * std::exp(log_scale(random));
        joint.max_deceleration = 1000 * unit * std::exp(log_scale(random));
        joint.max_jerk = 2e4 * unit * std::exp(log_scale(random));
    }
    setup.controller.blocks.look_ahead = std::uniform_int_distribution<std::size_t>(1, 30)(random);
    return setup;
}

bool is_within_limit(double value, double limit) {
    return value <= limit * (1 + 1e-9) + 1e-9;
}

/// The jerk of the joints in a straight segment, from its laws.
rrs::JointPos peak_jerk(const Segment& segment) {
    const auto slopes = [](const Segment& one) {
        return rrs::JointPos((one.end - one.start) / one.master.length());
    };
    rrs::JointPos peak = rrs::JointPos::Zero(segment.start.size());
    for (const LawSection& section : segment.master.sections()) {
        rrs::JointPos jerk = section.jerk * slopes(segment);
        if (segment.superimposed)
            jerk += segment.superimposed->master.sections()[0].jerk * slopes(*segment.superimposed);
        peak = peak.cwiseMax(jerk.cwiseAbs());
    }
    return peak;
}

void expect_limits(const Segment& segment, const PlannerSetup& setup) {
    const bool jerk = setup.controller.ramps.limit_jerk && segment.kind == SegmentKind::linear;
    const rrs::JointPos jerks = jerk ? peak_jerk(segment) : rrs::JointPos::Zero(setup.joint_count());
    for (int sample = 0; sample <= 24; ++sample) {
        const JointState state = segment.at(segment.duration_s * sample / 24);
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
            const double max = std::max(limits.max_acceleration, limits.deceleration());
            ASSERT_PRED2(is_within_limit, std::abs(state.velocity[joint]), limits.max_speed) << joint;
            ASSERT_PRED2(is_within_limit, std::abs(state.acceleration[joint]),
                         segment.superimposed ? limits.min_acceleration() : max)
                << joint;
        }
    }
    const double rounding = 1 + 1e-11 / segment.master.length();  // of slopes, computed from the ends
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double limit = setup.joints[static_cast<std::size_t>(joint)].max_jerk;
        ASSERT_PRED2(is_within_limit, jerks[joint], limit * rounding)
            << joint << " over " << segment.master.length() << (segment.superimposed ? " blended" : "");
    }
}

/// Expects one motion without jumps of position and speed, and of the acceleration if jerks are limited.
void expect_one_motion(const Collected& out, const PlannerSetup& setup) {
    JointState before;
    for (std::size_t i = 0; i < out.segments.size(); ++i) {
        const Segment& segment = out.segments[i];
        ASSERT_NO_FATAL_FAILURE(expect_limits(segment, setup)) << "segment " << i;
        const JointState first = segment.at(0);
        if (i > 0) {
            ASSERT_LT((first.position - before.position).norm(), 1e-9) << i;
            ASSERT_LT((first.velocity - before.velocity).norm(), 1e-6 * (1 + before.velocity.norm())) << i;
            const bool curved =
                segment.kind == SegmentKind::circular || out.segments[i - 1].kind == SegmentKind::circular;
            if (setup.controller.ramps.limit_jerk && !curved) {
                ASSERT_LT((first.acceleration - before.acceleration).norm(), 1e-4) << i;
            }
        }
        before = segment.at(segment.duration_s);
        ASSERT_LT((before.position - segment.end_position()).norm(), 1e-9);
    }
    EXPECT_LT(before.velocity.norm(), 1e-9);
}

double nearest_mm(const Collected& out, const Eigen::Vector3d& corner) {
    double nearest = 1e9;
    for (const Segment& segment : out.segments) {
        for (int i = 0; i <= 400; ++i) {
            const rrs::JointPos at = segment.position_at(segment.duration_s * i / 400);
            nearest = std::min(nearest, (at.head<3>() - corner).norm());
        }
    }
    return nearest;
}

double total_deviations(const Collected& out, int& count) {
    double max = 0;
    for (const Segment& segment : out.segments) {
        count += segment.deviation_mm > 0 ? 1 : 0;
        max = std::max(max, segment.deviation_mm);
    }
    return max;
}

class Blends : public testing::TestWithParam<CornerRule> {};

TEST_P(Blends, UseFullToleranceAtCornersOfSquare) {
    const PlannerSetup setup = blend_setup(GetParam());
    Path path(setup);
    path.tolerance_mm = 0.05;
    for (const auto& [x, y] : {std::pair{20, 0}, {20, 20}, {0, 20}, {0, 0}}) path.line(x, y);
    path.standstill();
    for (const Eigen::Vector3d& corner :
         {Eigen::Vector3d(20, 0, 0), Eigen::Vector3d(20, 20, 0), Eigen::Vector3d(0, 20, 0)}) {
        EXPECT_NEAR(nearest_mm(path.out(), corner), 0.05, 1e-9) << "the speed has use for all of it";
    }
    int count = 0;
    EXPECT_NEAR(total_deviations(path.out(), count), 0.05, 1e-12);
    EXPECT_EQ(count, 3);
    expect_one_motion(path.out(), setup);
}

TEST_P(Blends, UseControllerToleranceUnlessProgrammed) {
    PlannerSetup setup = blend_setup(GetParam());
    setup.controller.corners.blend_tolerance_mm = 0.01;
    for (const double programmed_mm : {0.0, 0.2}) {
        Path path(setup);
        path.tolerance_mm = programmed_mm;
        path.line(20, 0);
        path.line(20, 20);
        path.standstill();
        const double expected_value = programmed_mm > 0 ? programmed_mm : 0.01;
        EXPECT_NEAR(nearest_mm(path.out(), {20, 0, 0}), expected_value, 1e-9);
    }
    setup.controller.corners.blend_tolerance_mm = 0;
    Path exact(setup);
    exact.line(20, 0);
    exact.line(20, 20);
    exact.standstill();
    EXPECT_EQ(exact.out().segments.size(), 2U);
    EXPECT_EQ(exact.exit_speed(0), 0);
}

TEST_P(Blends, UseLessThanToleranceAtLowFeed) {
    const PlannerSetup setup = blend_setup(GetParam());
    Path path(setup);
    path.tolerance_mm = 1;
    path.line(20, 0, 10);
    path.line(20, 20, 10);
    path.standstill();
    int count = 0;
    const double deviation_mm = total_deviations(path.out(), count);
    EXPECT_EQ(count, 1);
    EXPECT_LT(deviation_mm, 0.1);
    EXPECT_NEAR(nearest_mm(path.out(), {20, 0, 0}), deviation_mm, 1e-9);
    for (const Segment& segment : path.out().segments) {
        if (!segment.superimposed) continue;
        EXPECT_NEAR(segment.master.at(0).v + segment.superimposed->master.at(0).v, 10, 1e-9);
    }
}

TEST_P(Blends, ReplaceAtMostHalfOfShortLine) {
    PlannerSetup setup = blend_setup(GetParam());
    setup.controller.corners.blend_tolerance_mm = 5;
    Path path(setup);
    path.line(20, 0);
    path.line(20, 1);
    path.line(40, 1);
    path.standstill();
    // Both blends meet in the middle of the short line.
    EXPECT_LT(nearest_mm(path.out(), {20, 0.5, 0}), 1e-9);
    expect_one_motion(path.out(), setup);
}

TEST_P(Blends, UseToleranceOfRotaryJoints) {
    PlannerSetup setup = blend_setup(GetParam());
    setup.joints.push_back({rrs::JointKind::revolute, -kUnlimited, kUnlimited, 1, 2});
    setup.joints.back().max_jerk = 40;
    setup.controller.corners.blend_tolerance_deg = 0.25;
    Path path(setup);
    path.line(joint_pos({20, 0, 0, 0.3}));
    path.line(joint_pos({40, 0, 0, 0}));  // straight on for the tool
    path.standstill();
    double most_rad = 0;
    for (const Segment& segment : path.out().segments)
        most_rad = std::max(most_rad, segment.end_position()[3]);
    EXPECT_NEAR((0.3 - most_rad) * 180 / kPi, 0.25, 1e-9);
    int count = 0;
    EXPECT_EQ(total_deviations(path.out(), count), 0) << "the tool stays on its way";
    expect_one_motion(path.out(), setup);
}

TEST_P(Blends, StopAtCornerBetweenLineAndArc) {
    const PlannerSetup setup = blend_setup(GetParam());
    Path path(setup);
    path.line(20, 0);
    path.arc(10, 0, 1.5, 50);  // up, off a corner
    path.standstill();
    ASSERT_EQ(path.out().segments.size(), 2U);
    EXPECT_EQ(path.exit_speed(0), 0);
    Path tangent(setup);
    tangent.line(20, 0);
    tangent.arc(10, -kPi / 2, 1.5, 50);
    tangent.standstill();
    EXPECT_GT(tangent.exit_speed(0), 40) << "nothing to round";
}

/// On random paths with arcs between the lines, of short lines and long ones, all limits hold.
TEST_P(Blends, KeepLimitsOnRandomPaths) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> unit(-1, 1);
    int blends = 0;
    for (int run = 0; run < 60; ++run) {
        const PlannerSetup setup = random_setup(random, GetParam());
        Path path(setup);
        path.tolerance_mm = std::exp(3 * unit(random) - 3);
        for (int i = 0; i < 40; ++i) {
            if (run % 3 == 0 && i % 5 == 4) {
                path.arc(std::exp(2 * unit(random)), kPi * unit(random), 1.5 + unit(random), 200);
                continue;
            }
            const double scale = std::exp(3 * unit(random));
            rrs::JointPos end = path.position();
            for (int joint = 0; joint < end.size(); ++joint)
                end[joint] += scale * (joint < 3 ? 1 : run % 2 * 0.02) * unit(random);
            path.line(end, 10 + 200 * std::abs(unit(random)));
        }
        path.standstill();
        EXPECT_LE(total_deviations(path.out(), blends), path.tolerance_mm * (1 + 1e-9));
        EXPECT_LT((path.out().segments.back().end_position() - path.position()).norm(), 1e-9);
        expect_one_motion(path.out(), setup);
        ASSERT_FALSE(testing::Test::HasFailure()) << "run " << run;
    }
    EXPECT_GT(blends, 400);
}

/// However few blocks are known, rounding corners costs no time compared with stopping at them. It costs
/// little if sharp corners must be passed without jumps of the acceleration.
TEST_P(Blends, AreHardlySlowerThanStopsWithShortLookAhead) {
    std::mt19937 random(32);
    const double allowed = GetParam() == CornerRule::smooth_blend ? 1.05 : 1.001;
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int run = 0; run < 20; ++run) {
        PlannerSetup setup = blend_setup(GetParam());
        setup.controller.blocks.look_ahead = run < 5 ? 100 : 1 + static_cast<std::size_t>(run % 5);
        PlannerSetup stops = setup;
        stops.controller.corners.continuous = CornerRule::stop;
        Path blended(setup);
        Path stopping(stops);
        for (int i = 0; i < 30; ++i) {
            const double scale = std::exp(3 * unit(random));
            const Eigen::Vector2d to =
                blended.position().head<2>() + scale * Eigen::Vector2d(unit(random), unit(random));
            for (Path* path : {&blended, &stopping}) path->line(to.x(), to.y());
        }
        for (Path* path : {&blended, &stopping}) path->standstill();
        EXPECT_LE(blended.out().time_s(), stopping.out().time_s() * allowed) << run;
    }
}

INSTANTIATE_TEST_SUITE_P(Both, Blends, testing::Values(CornerRule::parabolic_blend, CornerRule::smooth_blend),
                         [](const auto& tested) {
                             return tested.param == CornerRule::smooth_blend ? "Smooth" : "Parabolic";
                         });

/// 90 degrees: each of two joints changes its speed by v in 2 d / v, with d = 4 / sqrt(2) of the tolerance.
TEST(Blend, AccelerationLimitsSpeedAtRightAngle) {
    Path path(blend_setup(CornerRule::parabolic_blend));
    path.tolerance_mm = 0.05;
    path.line(20, 0);
    path.line(20, 20);
    path.standstill();
    const double cut_mm = 4 / std::sqrt(2) * 0.05;
    EXPECT_NEAR(path.exit_speed(0), std::sqrt(2 * cut_mm * 1000), 1e-9);
    EXPECT_EQ(path.out().segments[1].limited_by.kind, LimitKind::corner);
    EXPECT_EQ(path.out().segments[1].target_id, 1) << "up to the point that is nearest to the corner";
    EXPECT_TRUE(path.out().segments[1].reaches_target);
    EXPECT_EQ(path.out().segments[2].target_id, 2);
}

TEST(Blend, JerkLimitsSpeedOfSmoothBlend) {
    Path path(blend_setup(CornerRule::smooth_blend));
    path.tolerance_mm = 0.05;
    path.line(20, 0);
    path.line(20, 20);
    path.standstill();
    const double cut_mm = 6 / std::sqrt(2) * 0.05;
    EXPECT_NEAR(path.exit_speed(0), std::cbrt(2e4 * cut_mm * cut_mm), 1e-9);
}

TEST(Blend, CanBeSelectedAsFlybyCriterion) {
    PlannerSetup setup = gantry_setup();
    setup.controller.planner = rrs::PlannerKind::look_ahead;
    setup.controller.corners.continuous = CornerRule::parabolic_blend;
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    EXPECT_EQ(ready.planner.SetFlybyCriteriaParameter(3, -1, 0.1), rrs::Status::RRS_SUCCESS);
    EXPECT_EQ(ready.planner.SelectFlybyCriteria(3), rrs::Status::RRS_SUCCESS);
}

}  // namespace
}  // namespace gsim::motion::blend_test
