#include <gtest/gtest.h>

#include "tests/motion/machines.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::line_move_test {
namespace {

using rrs::Dominance;
using rrs::Status;

// At the middle of the gantry, linear motion at 100 mm/s.
class LineMove : public testing::Test {
  protected:
    explicit LineMove(const PlannerSetup& setup = gantry_setup()) : at(setup, start) {
        at.planner.SelectMotionType(rrs::MotionType::linear);
        at.planner.SetCartesianPositionSpeed(100);
    }
    const Segment& go(std::initializer_list<double> target) {
        EXPECT_EQ(at.to(joint_pos(target)), Status::RRS_SUCCESS) << at.message();
        return at.last();
    }

    const rrs::JointPos start = joint_pos({500, 500, 300, 0, 0});
    ReadyPlanner at;
    const double acceleration = 490.33;
    const double quarter = kPi / 2;
};

TEST_F(LineMove, TakesTrapezoidTimeAtProgrammedSpeed) {
    const Segment& segment = go({800, 900, 300, 0, 0});
    EXPECT_EQ(segment.kind, SegmentKind::linear);
    EXPECT_DOUBLE_EQ(segment.length_mm, 500);
    EXPECT_DOUBLE_EQ(segment.duration_s, 500 / 100.0 + 100 / acceleration);
    EXPECT_DOUBLE_EQ(segment.master.peak_speed(), 100);
    EXPECT_DOUBLE_EQ(segment.path_speed_mm_s(2), 100);
    EXPECT_TRUE(segment.followers().empty());
    EXPECT_TRUE(segment.position_at(segment.duration_s / 2).isApprox(joint_pos({650, 700, 300, 0, 0})));
}

TEST_F(LineMove, PathFeedLimitCapsSpeed) {
    at.planner.SetCartesianPositionSpeed(1000);
    EXPECT_DOUBLE_EQ(go({1500, 500, 300, 0, 0}).duration_s, 1000 / 254.0 + 254 / acceleration);
}

TEST_F(LineMove, RapidUsesOnlyRapidAndJointLimits) {
    at.planner.SetCartesianPositionSpeed(1);
    at.planner.SetCartesianPositionAcceleration(1);
    at.planner.SetRapid(true);
    EXPECT_DOUBLE_EQ(go({1500, 500, 300, 0, 0}).duration_s, 1000 / 508.0 + 508 / acceleration);
    // Along a diagonal each joint has only its share of the path: acceleration rises, speed is capped by the
    // path.
    at.planner.SetInitialPosition(rrs::CartPos::Identity(), start, "");
    const Segment& diagonal = go({1500, 1500, 300, 0, 0});
    EXPECT_DOUBLE_EQ(diagonal.duration_s, trapezoid_s(1000 * std::sqrt(2), 508, acceleration * std::sqrt(2)));
}

TEST_F(LineMove, RapidNeedsNoProgrammedSpeed) {
    ReadyPlanner fresh(gantry_setup(), start);
    fresh.planner.SelectMotionType(rrs::MotionType::linear);
    EXPECT_EQ(fresh.to(joint_pos({600, 500, 300, 0, 0})), Status::RRS_ZERO_SPEED);
    EXPECT_EQ(fresh.message(),
              "No speed is programmed for this motion; set one with SetCartesianPositionSpeed first.");
    fresh.planner.SetRapid(true);
    EXPECT_EQ(fresh.to(joint_pos({600, 500, 300, 0, 0})), Status::RRS_SUCCESS);
}

// Expected are the ramps that each joint may make in its share of the path, the slowest of them for all.
TEST_F(LineMove, JointsMoveInProportionToSlowestJoint) {
    const Segment& slow = go({600, 500, 300, kPi, 0});
    EXPECT_TRUE(slow.followers().empty());
    EXPECT_DOUBLE_EQ(slow.duration_s, trapezoid_s(100, quarter / kPi * 100, quarter / kPi * 100));
    EXPECT_EQ(slow.limited_by, (LimitCause{LimitKind::joint_speed, 3}));
    const Segment& fast = go({1000, 500, 300, kPi - 0.1, 0.2});
    EXPECT_DOUBLE_EQ(fast.duration_s, 400 / 100.0 + 100 / acceleration);
    for (const double part : {0.01, 0.1, 0.3, 0.5, 0.8}) {
        const rrs::JointPos gone = fast.position_at(fast.duration_s * part) - fast.start;
        EXPECT_NEAR(gone[3] / gone[0], -0.1 / 400, 1e-12);
        EXPECT_NEAR(gone[4] / gone[0], 0.2 / 400, 1e-12);
    }
}

TEST_F(LineMove, PureRotaryMoveIsPlannedInJointAngles) {
    const Segment& limits = go({500, 500, 300, 0.6, 0.8});
    EXPECT_EQ(limits.length_mm, 0);
    EXPECT_EQ(limits.path_speed_mm_s(0.5), 0);
    EXPECT_DOUBLE_EQ(limits.master.length(), 1);
    EXPECT_DOUBLE_EQ(limits.duration_s, trapezoid_s(1, quarter / 0.8, quarter / 0.8));
    at.planner.SetCartesianOrientationSpeed(0.25);
    EXPECT_DOUBLE_EQ(go({500, 500, 300, 0, 0}).duration_s, trapezoid_s(1, 0.25, quarter / 0.8));
    at.planner.SetRapid(true);
    EXPECT_DOUBLE_EQ(go({500, 500, 300, 0.6, 0.8}).duration_s, trapezoid_s(1, quarter / 0.8, quarter / 0.8));
}

TEST_F(LineMove, DominanceSelectsProgrammedSpeed) {
    at.planner.SetCartesianOrientationSpeed(0.1);
    const auto time_to = [&](Dominance dominance) {
        at.planner.SelectDominantInterpolation(dominance);
        at.planner.SetInitialPosition(rrs::CartPos::Identity(), start, "");
        return go({1000, 500, 300, 1, 0}).duration_s;
    };
    const double by_position = 500 / 100.0 + 100 / acceleration;
    const double by_orientation = trapezoid_s(500, 50, acceleration);
    EXPECT_DOUBLE_EQ(time_to(Dominance::automatic), by_orientation);
    EXPECT_DOUBLE_EQ(time_to(Dominance::orientation), by_orientation);
    EXPECT_DOUBLE_EQ(time_to(Dominance::position), by_position);
    at.planner.SetCartesianOrientationSpeed(1e3);
    EXPECT_DOUBLE_EQ(time_to(Dominance::orientation), 500 / 254.0 + 254 / acceleration);
    EXPECT_DOUBLE_EQ(time_to(Dominance::automatic), by_position);
}

TEST_F(LineMove, DominanceDoesNotAffectMovesOfOneKind) {
    at.planner.SelectDominantInterpolation(Dominance::orientation);
    EXPECT_DOUBLE_EQ(go({1000, 500, 300, 0, 0}).duration_s, 500 / 100.0 + 100 / acceleration);
    at.planner.SelectDominantInterpolation(Dominance::position);
    at.planner.SetCartesianOrientationSpeed(0.1);
    EXPECT_DOUBLE_EQ(go({1000, 500, 300, 1, 0}).duration_s, 1 / 0.1 + 0.1 / quarter);
}

TEST_F(LineMove, OverridesScaleProgrammedValues) {
    at.planner.SetOverrideSpeed(50);
    EXPECT_DOUBLE_EQ(go({1000, 500, 300, 0, 0}).duration_s, 500 / 50.0 + 50 / acceleration);
    at.planner.SetCartesianPositionAcceleration(200);
    at.planner.SetOverrideAcceleration(25);
    EXPECT_DOUBLE_EQ(go({500, 500, 300, 0, 0}).duration_s, 500 / 50.0 + 50 / 50.0);
    at.planner.SetOverrideSpeed(200);
    at.planner.SetOverrideAcceleration(200);
    EXPECT_DOUBLE_EQ(go({1000, 500, 300, 0, 0}).duration_s, 500 / 200.0 + 200 / 400.0);
}

TEST_F(LineMove, MotionTimeReplacesSpeedOfOneMove) {
    at.planner.SetMotionTime(20);
    EXPECT_EQ(go({1000, 500, 300, 1, 0}).duration_s, 20);
    EXPECT_DOUBLE_EQ(go({500, 500, 300, 1, 0}).duration_s, 500 / 100.0 + 100 / acceleration);
    at.planner.SetMotionTime(3);  // faster than programmed
    EXPECT_EQ(go({1000, 500, 300, 1, 0}).duration_s, 3);
}

TEST_F(LineMove, RaisesAndReportsTooShortMotionTime) {
    at.planner.SetMotionTime(0.1);
    EXPECT_EQ(at.to(joint_pos({1000, 500, 300, 0, 0})), Status::RRS_MOTION_TIME_RAISED);
    const double min = 500 / 254.0 + 254 / acceleration;
    EXPECT_DOUBLE_EQ(at.last().duration_s, min);
    EXPECT_EQ(at.message().substr(0, 14), "The move takes");
    EXPECT_EQ(at.planner.last_error().status, Status::RRS_MOTION_TIME_RAISED);
    EXPECT_EQ(at.to(joint_pos({500, 500, 300, 0, 0})), Status::RRS_SUCCESS);
}

TEST_F(LineMove, RejectedTargetKeepsMotionTimeForNext) {
    at.planner.SetMotionTime(9);
    EXPECT_EQ(at.to(joint_pos({-1, 500, 300, 0, 0})), Status::RRS_JOINT_LIMIT);
    EXPECT_EQ(go({700, 500, 300, 0, 0}).duration_s, 9);
}

TEST_F(LineMove, ZeroDistanceGivesSegmentWithoutDuration) {
    const Segment& segment = go({500, 500, 300, 0, 0});
    EXPECT_EQ(segment.kind, SegmentKind::linear);
    EXPECT_EQ(segment.target_id, 1);
    EXPECT_EQ(segment.duration_s, 0);
    EXPECT_EQ(segment.length_mm, 0);
    EXPECT_EQ(segment.position_at(0), start);
    EXPECT_EQ(segment.at(0).velocity, joint_pos({0, 0, 0, 0, 0}));
    EXPECT_EQ(segment.at(0).position, start);
}

TEST_F(LineMove, IgnoresDistanceWithinRounding) {
    const Segment& segment = go({500 + 1e-12, 500, 300, 1, 0});
    EXPECT_EQ(segment.length_mm, 0);
    EXPECT_DOUBLE_EQ(segment.master.length(), 1);
    EXPECT_EQ(segment.end[0], 500 + 1e-12);
}

TEST_F(LineMove, SecondaryLinearAxisLeadsOnlyIfAlone) {
    PlannerSetup setup = gantry_setup();
    setup.joints = {setup.joints[0], setup.joints[1], setup.joints[2], setup.joints[0], setup.joints[3]};
    setup.joints[3].max_speed = 20;
    std::vector<kinematics::DhLink> rows(5);
    rows[4].kind = rrs::JointKind::revolute;
    const auto identity = rrs::CartPos::Identity();
    setup.kinematics =
        std::make_shared<kinematics::ChainKinematics>(kinematics::DhChain(identity, rows, identity));
    ReadyPlanner planner(setup, joint_pos({0, 0, 0, 0, 0}));
    planner.planner.SelectMotionType(rrs::MotionType::linear);
    planner.planner.SetCartesianPositionSpeed(10);

    EXPECT_EQ(planner.to(joint_pos({0, 0, 0, 100, 0.1})), Status::RRS_SUCCESS);
    EXPECT_DOUBLE_EQ(planner.last().duration_s, 100 / 10.0 + 10 / acceleration);
    EXPECT_DOUBLE_EQ(planner.last().length_mm, 100);
    EXPECT_TRUE(planner.last().followers().empty());
    EXPECT_EQ(planner.to(joint_pos({10, 0, 0, 200, 0.1})), Status::RRS_SUCCESS);
    EXPECT_DOUBLE_EQ(planner.last().duration_s, trapezoid_s(10, 2, acceleration / 10));
    EXPECT_DOUBLE_EQ(planner.last().length_mm, 10);
}

// Controller with joints outside the path that arrive with it by ramps of their own.
class IndependentRamps : public LineMove {
  protected:
    IndependentRamps() : LineMove(independent_ramps()) {}
    static PlannerSetup independent_ramps() {
        PlannerSetup setup = gantry_setup();
        setup.controller.coordination.independent_ramps = true;
        return setup;
    }
};

TEST_F(IndependentRamps, SlowerRotaryJointSetsTimeOfPath) {
    const Segment& segment = go({600, 500, 300, kPi, 0});
    EXPECT_DOUBLE_EQ(segment.duration_s, kPi / quarter + 1);
    ASSERT_EQ(segment.followers().size(), 1U);
    EXPECT_EQ(segment.followers()[0].joint, 3);
    EXPECT_DOUBLE_EQ(segment.followers()[0].law.peak_speed(), quarter);
    EXPECT_LT(segment.master.peak_speed(), 100);
    EXPECT_DOUBLE_EQ(segment.master.duration_s(), segment.duration_s);
}

TEST_F(IndependentRamps, FasterRotaryJointIsStretchedToPath) {
    const Segment& segment = go({1000, 500, 300, -0.1, 0.2});
    EXPECT_DOUBLE_EQ(segment.duration_s, 500 / 100.0 + 100 / acceleration);
    ASSERT_EQ(segment.followers().size(), 2U);
    for (const Follower& follower : segment.followers()) {
        EXPECT_EQ(follower.law.duration_s(), segment.duration_s);
        EXPECT_DOUBLE_EQ(follower.law.at(0).a, quarter);
    }
    EXPECT_NEAR(segment.position_at(segment.duration_s / 2)[3], -0.05, 1e-12);
    EXPECT_NEAR(segment.position_at(segment.duration_s / 2)[4], 0.1, 1e-12);
}

TEST_F(IndependentRamps, ProgrammedOrientationSpeedSetsTime) {
    at.planner.SetCartesianOrientationSpeed(0.1);
    EXPECT_DOUBLE_EQ(go({1000, 500, 300, 1, 0}).duration_s, 1 / 0.1 + 0.1 / quarter);
}

}  // namespace
}  // namespace gsim::motion::line_move_test
