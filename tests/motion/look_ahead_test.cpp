// A window of blocks, speeds at corners by the controller's rule, and limits that always hold.
#include "motion/lookahead/look_ahead.h"

#include <gtest/gtest.h>

#include "tests/motion/look_ahead_path.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::look_ahead_test {
namespace {

using rrs::CornerRule;
using rrs::PathMode;

/// Expects the right end, without a jump of position or of speed.
void expect_one_motion(const Collected& out, const PlannerSetup& setup) {
    for (std::size_t i = 0; i < out.segments.size(); ++i) {
        const Segment& segment = out.segments[i];
        const JointState first = segment.at(0);
        ASSERT_LT((first.position - segment.start).norm(), 1e-9);
        ASSERT_LT((segment.at(segment.duration_s).position - segment.end).norm(), 1e-9);
        const double before = i == 0 ? 0 : out.segments[i - 1].master.end_speed();
        ASSERT_NEAR(segment.master.start_speed(), before, 1e-9 * (1 + before)) << i;
        const rrs::JointPos& left = i == 0 ? segment.start : out.segments[i - 1].end;
        ASSERT_LT((segment.start - left).norm(), 1e-9);
        for (int sample = 0; sample <= 20; ++sample) {
            const JointState state = segment.at(segment.duration_s * sample / 20);
            for (int joint = 0; joint < setup.joint_count(); ++joint) {
                const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
                ASSERT_LE(std::abs(state.velocity[joint]), limits.max_speed * (1 + kRelative));
                ASSERT_LE(std::abs(state.acceleration[joint]), limits.max_acceleration * (1 + 1e-8) + 1e-6);
            }
        }
    }
    EXPECT_EQ(out.segments.back().master.end_speed(), 0);
}

/// Checks jerk limits: the acceleration along the path is 0 at the ends of blocks and changes within the jerk
/// of the joints. On a curve the part of the jerk that turns with the path, v^3 curvature^2, keeps the limit,
/// too.
void expect_jerk_along_the_way(const Collected& out, const PlannerSetup& setup) {
    for (const Segment& segment : out.segments) {
        const bool curved = segment.kind == SegmentKind::circular;
        double jerk = kUnlimited;  // of the path
        for (int joint = 0; joint < 3; ++joint) {
            const double share =
                curved ? segment.arc.max_share(joint)
                       : std::abs(segment.end[joint] - segment.start[joint]) / segment.master.length();
            if (share > 1e-9)
                jerk = std::min(jerk, setup.joints[static_cast<std::size_t>(joint)].max_jerk / share);
        }
        double acceleration = 0;
        for (const LawSection& section : segment.master.sections()) {
            ASSERT_LE(std::abs(section.jerk), jerk * (1 + 1e-7));
            ASSERT_NEAR(section.a0, acceleration, 1e-6 * (1 + std::abs(acceleration)));
            acceleration = section.a0 + section.jerk * section.duration_s;
        }
        ASSERT_NEAR(acceleration, 0, 1e-5);
        if (!curved) continue;
        const double curvature = segment.arc.max_curvature();
        ASSERT_LE(std::pow(segment.master.peak_speed(), 3) * curvature * curvature, jerk * (1 + 1e-9));
    }
}

TEST(LookAhead, SingleLineIsTrapezoid) {
    Path path(router_setup());
    path.line(100, 0);
    EXPECT_TRUE(path.out().segments.empty()) << "more may come";
    path.standstill();
    EXPECT_NEAR(path.out().time_s(), 1.1, 1e-12);
    EXPECT_EQ(path.out().segments[0].limited_by, (LimitCause{LimitKind::feed, -1}));
}

/// Speeds that were measured on grbl 1.1 with these settings.
TEST(LookAhead, JunctionDeviationMatchesGrbl) {
    const std::pair<double, double> kMeasured[] = {
        {15, 34.19}, {45, 11.46}, {90, 5.84}, {135, 2.59}, {180, 0}};
    for (const auto& [turn_deg, speed] : kMeasured) {
        Path path(router_setup());
        path.line(50, 0);
        const double turn = turn_deg * kPi / 180;
        path.line(50 + 50 * std::cos(turn), 50 * std::sin(turn));
        path.standstill();
        EXPECT_NEAR(path.exit_speed(0), speed, 0.01) << turn_deg;
        EXPECT_TRUE(path.out().segments[0].limited_by.kind == LimitKind::feed);
    }
}

TEST(LookAhead, ShortBlocksInWindowLimitSpeed) {
    PlannerSetup setup = router_setup();
    Path path(setup);
    for (int i = 1; i <= 400; ++i) path.line(0.05 * i, 0);
    path.standstill();
    const double expected = std::sqrt(2 * 1000 * 14 * 0.05);
    EXPECT_NEAR(path.exit_speed(200), expected, 1e-9);
    EXPECT_EQ(path.out().segments[200].limited_by.kind, LimitKind::look_ahead);
    setup.controller.blocks.look_ahead = 1000;
    Path far(setup);
    for (int i = 1; i <= 400; ++i) far.line(0.05 * i, 0);
    far.standstill();
    EXPECT_NEAR(far.out().time_s(), trapezoid_s(20, 100, 1000), 1e-9) << "as one line";
    expect_one_motion(far.out(), setup);
}

TEST(LookAhead, ExactPathModeStopsOnlyAtCorners) {
    PlannerSetup setup = router_setup();
    setup.controller.corners.exact_path = CornerRule::stop;
    Path path(setup);
    path.mode = PathMode::exact_stop;
    path.line(10, 0);
    path.mode = PathMode::exact_path;
    path.line(20, 0);
    path.line(30, 0);
    path.line(30, 10);
    path.standstill();
    EXPECT_EQ(path.exit_speed(0), 0);
    EXPECT_GT(path.exit_speed(1), 50);
    EXPECT_EQ(path.exit_speed(2), 0);
    EXPECT_NEAR(path.out().time_s(), 2 * trapezoid_s(10, 100, 1000) + trapezoid_s(20, 100, 1000), 1e-9);
}

TEST(LookAhead, VelocityStepOfJointsLimitsCornerSpeed) {
    PlannerSetup setup = router_setup();
    setup.controller.corners.continuous = CornerRule::velocity_step;
    setup.joints[0].max_speed_step = 12;
    setup.joints[1].max_speed_step = 20;
    Path path(setup);
    path.line(50, 0);
    path.line(50, 50);  // X loses all of the speed, Y gains it
    path.standstill();
    EXPECT_NEAR(path.exit_speed(0), 12, 1e-9);
    setup.joints[0].max_speed_step = setup.joints[1].max_speed_step = kUnlimited;
    setup.controller.corners.speed_step_s = 0.003;
    Path over_time(setup);
    over_time.line(50, 0);
    over_time.line(50, 50);
    over_time.standstill();
    EXPECT_NEAR(over_time.exit_speed(0), 3, 1e-9);
}

TEST(LookAhead, StopsBetweenRapidAndFeedIfConfigured) {
    for (const bool stops : {false, true}) {
        PlannerSetup setup = router_setup();
        setup.controller.corners.stop_between_rapid_and_feed = stops;
        Path path(setup);
        path.rapid = true;
        path.line(50, 0);
        path.rapid = false;
        path.line(100, 0, 20);
        path.standstill();
        EXPECT_NEAR(path.exit_speed(0), stops ? 0 : 20, 1e-9);
    }
}

TEST(LookAhead, CentripetalShareReducesAccelerationAlongArc) {
    PlannerSetup setup = router_setup();
    setup.controller.ramps.centripetal_share = 0.6;
    Path path(setup);
    path.arc(20, 0, 2 * kPi, 1000);
    path.standstill();
    const Segment& segment = path.out().segments[0];
    EXPECT_EQ(segment.limited_by.kind, LimitKind::joint_speed) << "100 mm/s is less";
    setup.joints.assign(3, {rrs::JointKind::prismatic, -kUnlimited, kUnlimited, 500, 1000});
    Path fast(setup);
    fast.arc(20, 0, 2 * kPi, 1000);
    fast.standstill();
    EXPECT_EQ(fast.out().segments[0].limited_by.kind, LimitKind::centripetal);
    EXPECT_NEAR(fast.out().time_s(), trapezoid_s(40 * kPi, std::sqrt(0.6 * 1000 * 20), 800), 1e-9);
    expect_one_motion(fast.out(), setup);
}

TEST(LookAhead, CentripetalShareAboveOneKeepsFullAcceleration) {
    PlannerSetup setup = router_setup();
    setup.joints.assign(3, {rrs::JointKind::prismatic, -kUnlimited, kUnlimited, 500, 1000});
    setup.controller.ramps.centripetal_share = 2;
    Path path(setup);
    path.arc(20, 0, 2 * kPi, 1000);
    path.standstill();
    EXPECT_EQ(path.out().segments[0].limited_by.kind, LimitKind::centripetal);
    EXPECT_NEAR(path.out().time_s(), trapezoid_s(40 * kPi, std::sqrt(2 * 1000 * 20.0), 1000), 1e-9);
}

TEST(LookAhead, ContinuousModeUsesItsAccelerationShare) {
    PlannerSetup setup = router_setup();
    setup.controller.ramps.continuous_acceleration_share = 0.5;
    for (const auto& [mode, acceleration] :
         {std::pair{rrs::PathMode::continuous, 500.0}, std::pair{rrs::PathMode::exact_path, 1000.0}}) {
        Path path(setup);
        path.mode = mode;
        path.line(100, 0, 50);
        path.standstill();
        EXPECT_NEAR(path.out().time_s(), trapezoid_s(100, 50, acceleration), 1e-9);
    }
}

/// 200 lines of 0.1 mm at 10 ms each: 10 mm/s, but for the ramps at both ends. An arc is one block, also as
/// chords.
TEST(LookAhead, BlockTimeLimitsSpeed) {
    PlannerSetup setup = router_setup();
    setup.controller.blocks.time_s = 0.01;
    Path lines(setup);
    for (int i = 1; i <= 200; ++i) lines.line(0.1 * i, 0, 50);
    lines.standstill();
    EXPECT_NEAR(lines.out().time_s(), trapezoid_s(20, 10, 1000), 1e-9);
    EXPECT_EQ(lines.out().segments[100].limited_by.kind, LimitKind::block_time);

    setup.controller.blocks.time_s = 2;
    for (const double chord_tolerance_mm : {0.0, 0.002}) {
        setup.controller.curves.arc_chord_tolerance_mm = chord_tolerance_mm;
        Path arc(setup);
        arc.arc(5, 0, 2 * kPi, 50);
        arc.standstill();
        EXPECT_NEAR(arc.out().time_s(), 2, 0.05) << chord_tolerance_mm;
        EXPECT_GE(arc.out().time_s(), 2);
    }
}

TEST(LookAhead, ArcsBecomeChords) {
    PlannerSetup setup = router_setup();
    setup.controller.curves.arc_chord_tolerance_mm = 0.002;
    Path path(setup);
    path.arc(20, 0, 2 * kPi, 50);
    path.standstill();
    ASSERT_EQ(path.out().segments.size(), 222U) << "grbl 1.1 makes that many";
    for (const Segment& segment : path.out().segments) {
        const Eigen::Vector3d middle = (segment.start + segment.end).head<3>() / 2;
        EXPECT_NEAR((middle - Eigen::Vector3d(-20, 0, 0)).norm(), 20, 0.0021);
        EXPECT_EQ(segment.target_id, 1);
    }
}

TEST(LookAhead, RoundsBlockEndsToJointSteps) {
    PlannerSetup setup = router_setup();
    setup.controller.curves.arc_chord_tolerance_mm = 0.002;
    for (JointSetup& joint : setup.joints) joint.step = 0.25;
    Path path(setup);
    path.line(1.1, 0.3);
    path.line(1.12, 0.3);  // less than a step: no distance at all
    path.line(2.2, 0.3);
    path.standstill();
    ASSERT_EQ(path.out().segments.size(), 2U);
    EXPECT_NEAR(path.out().segments[0].end[0], 1.0, 1e-12);
    EXPECT_NEAR(path.out().segments[1].start[0], 1.0, 1e-12);
    EXPECT_NEAR(path.out().segments[1].end[0], 2.25, 1e-12);
}

TEST(LookAhead, InverseTimeSetsSpeedOfLine) {
    PlannerSetup setup = router_setup();
    Collected out;
    LookAhead model(setup, out);
    PathMove move;
    move.start = rrs::JointPos::Zero(3);
    move.end = move.start;
    move.end[0] = 60;
    move.rules.min_duration_s = 3;
    ASSERT_TRUE(model.add(move));
    model.plan_to_standstill();
    EXPECT_NEAR(out.time_s(), 3 + 20.0 / 1000, 1e-12) << "60 mm at 20 mm/s, the ramps on top";
}

TEST(LookAhead, RejectsMoveWithoutSpeed) {
    PlannerSetup setup = router_setup();
    Collected out;
    LookAhead model(setup, out);
    PathMove move;
    move.start = move.end = rrs::JointPos::Zero(3);
    move.rules.programmed_speed_mm_s = 0;
    EXPECT_TRUE(model.add(move)) << "no way, no speed needed";
    move.end[0] = 1;
    EXPECT_EQ(model.add(move).error().status, rrs::Status::RRS_ZERO_SPEED);
}

/// Random paths of lines and arcs, with and without jerk limits, by each rule.
TEST(LookAhead, KeepsLimitsOnRandomPaths) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int run = 0; run < 60; ++run) {
        PlannerSetup setup = router_setup();
        setup.controller.corners.continuous =
            run % 2 == 0 ? CornerRule::junction_deviation : CornerRule::velocity_step;
        setup.controller.ramps.centripetal_share = 0.866;
        setup.controller.blocks.look_ahead = static_cast<std::size_t>(1 + 40 * unit(random));
        setup.controller.ramps.limit_jerk = run % 3 == 0;
        for (JointSetup& joint : setup.joints) {
            joint.max_speed = 50 + 400 * unit(random);
            joint.max_acceleration = 100 + 3000 * unit(random);
            joint.max_jerk = 1e4 + 1e6 * unit(random);
        }
        Path path(setup);
        double heading = 0;
        Eigen::Vector2d at(0, 0);
        for (int i = 0; i < 60; ++i) {
            const double length = std::exp(6 * unit(random) - 3);
            if (i % 4 == 3) {
                const double sweep = unit(random) * 5 + 0.1;
                const double lift_mm = i % 8 == 3 ? 20 * length * (unit(random) - 0.5) : 0;
                path.arc(length, heading - kPi / 2, sweep, 10 + 500 * unit(random), lift_mm);
                heading += sweep;
                at = path.position().head<2>();
                continue;
            }
            heading += (unit(random) - 0.5) * (i % 5 == 0 ? 6 : 0.2);
            at += length * Eigen::Vector2d(std::cos(heading), std::sin(heading));
            path.line(at.x(), at.y(), 10 + 500 * unit(random));
        }
        path.standstill();
        expect_one_motion(path.out(), setup);
        if (setup.controller.ramps.limit_jerk) expect_jerk_along_the_way(path.out(), setup);
        ASSERT_FALSE(testing::Test::HasFailure()) << "run " << run;
    }
}

/// Blocks that are planned only when something must come out move as those that are planned one by one: by
/// the window's length from each block, backwards, and from the start forwards.
TEST(LookAhead, ExitSpeedsAreOptimalInWindow) {
    std::mt19937 random(71);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int run = 0; run < 40; ++run) {
        PlannerSetup setup = router_setup();
        setup.controller.blocks.look_ahead = 1 + static_cast<std::size_t>(12 * unit(random));
        setup.controller.corners.stop_between_rapid_and_feed = false;
        Path path(setup);
        std::vector<double> length, feed;
        for (int i = 0; i < 120; ++i) {
            length.push_back(std::exp(6 * unit(random) - 4));
            feed.push_back(unit(random) < 0.1 ? 5 : 100);
            path.line(path.position()[0] + length.back(), 0, feed.back());
        }
        path.standstill();
        double speed = 0;
        for (std::size_t i = 0; i < length.size(); ++i) {
            const std::size_t end = std::min(i + setup.controller.blocks.look_ahead, length.size());
            double planned = 0;
            for (std::size_t k = end; --k > i;) {
                const double corner = std::min(feed[k - 1], feed[k]);
                planned = std::min(corner, std::sqrt(planned * planned + 2 * 1000 * length[k]));
            }
            if (i + 1 >= end) planned = 0;
            speed = std::min(planned, std::sqrt(speed * speed + 2 * 1000 * length[i]));
            ASSERT_NEAR(path.exit_speed(i), speed, 1e-9 * (1 + speed)) << "run " << run << " block " << i;
        }
    }
}

/// Each block is planned once, not once for each following block: this would take minutes.
TEST(LookAhead, PlansManyPendingBlocks) {
    PlannerSetup setup = router_setup();
    setup.controller.blocks.look_ahead = 200'000;
    Path path(setup);
    for (int i = 1; i <= 60'000; ++i) path.line(1e-5 * i, 0);
    path.standstill();
    EXPECT_NEAR(path.out().time_s(), trapezoid_s(0.6, 100, 1000), 1e-6) << "as one line";
}

/// A chord of a small arc may vanish on the grid of the joints' steps; the one before it reaches the target.
TEST(LookAhead, ArcReachesTargetIfLastChordIsRoundedAway) {
    PlannerSetup setup = router_setup();
    setup.controller.curves.arc_chord_tolerance_mm = 0.0002;
    for (JointSetup& joint : setup.joints) joint.step = 0.01;
    std::mt19937 random(72);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int run = 0; run < 200; ++run) {
        Path path(setup);
        path.arc(0.02 + 0.1 * unit(random), 6 * unit(random), 0.6 + 5 * unit(random), 20);
        path.standstill();
        if (path.out().segments.empty()) continue;
        ASSERT_TRUE(path.out().segments.back().reaches_target) << "run " << run;
    }
}

}  // namespace
}  // namespace gsim::motion::look_ahead_test
