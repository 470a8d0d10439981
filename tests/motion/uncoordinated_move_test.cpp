// Rapids that are not interpolated: each joint by its own limits, with a time of its own.

#include "motion/exact_stop/uncoordinated_move.h"

#include "tests/motion/motion_checks.h"
#include "tests/motion/planner_under_test.h"

namespace gsim::motion::apart_move_test {
namespace {

using rrs::Status;

PlannerSetup apart(PlannerSetup setup) {
    setup.controller.coordination.interpolated_rapids = false;
    setup.path.max_rapid_mm_s = kUnlimited;
    return setup;
}

PlannerSetup apart_slides() {
    return apart(three_slide_machine());
}

class ReadyRapids : public ReadyPlanner {
  public:
    ReadyRapids(const PlannerSetup& setup, const rrs::JointPos& start) : ReadyPlanner(setup, start) {
        planner.SelectMotionType(rrs::MotionType::linear);
        planner.SetRapid(true);
    }
};

double distance_mm(const Segment& segment, double from_s, double to_s) {
    const rrs::JointPos displacement = segment.position_at(to_s) - segment.position_at(from_s);
    double square = 0;
    for (int joint = 0; joint < displacement.size(); ++joint)
        square += segment.carries_path(joint) ? displacement[joint] * displacement[joint] : 0;
    return std::sqrt(square);
}

double way_by_chords_mm(const Segment& segment) {
    constexpr int kChords = 1000;
    double sum_mm = 0;
    double from_s = 0;
    for (const double to_s : uncoordinated_instants_s(segment)) {
        const double chord_s = (to_s - from_s) / kChords;
        for (int i = 0; i < kChords; ++i)
            sum_mm += distance_mm(segment, from_s + i * chord_s, from_s + (i + 1) * chord_s);
        from_s = to_s;
    }
    return sum_mm;
}

class UncoordinatedMoveServices : public AnyPlanner {};
INSTANTIATE_TEST_SUITE_P(Ways, UncoordinatedMoveServices, all_ways(), way_name);

// 100 mm/s and 1000 mm/s2: 0.1 s and 5 mm for a ramp.
TEST_P(UncoordinatedMoveServices, JointsReachTargetIndependentlyIfNotInterpolated) {
    for (const bool interpolated : {true, false}) {
        PlannerSetup setup = apart_slides();
        setup.controller.coordination.interpolated_rapids = interpolated;
        ReadyShell ready(make(setup), joint_pos({0, 0, 0}));
        ready.planner.SelectMotionType(rrs::MotionType::linear);
        ready.planner.SetRapid(true);
        ready.planner.SetInterpolationTime(0.25);
        ASSERT_EQ(ready.to(joint_pos({100, 40, 0})), Status::RRS_SUCCESS);
        const rrs::JointPos first = ready.step().joints, second = ready.step().joints;
        EXPECT_NEAR(first[0], 20, 1e-9);
        EXPECT_NEAR(first[1], interpolated ? 8 : 20, 1e-9) << "as fast as the other one";
        EXPECT_NEAR(second[0], 45, 1e-9);
        EXPECT_NEAR(second[1], interpolated ? 18 : 40, 1e-9) << "there after 0.5 s";
        rrs::JointPos at;
        EXPECT_EQ(ready.run_out(at), 1);
        EXPECT_EQ(at, joint_pos({100, 40, 0}));
        EXPECT_NEAR(ready.time_s, 1.1, 1e-9) << "of the slowest";
    }
}

TEST_P(UncoordinatedMoveServices, FeedsStayOnLine) {
    ReadyShell ready(make(apart_slides()), joint_pos({0, 0, 0}));
    ready.planner.SelectMotionType(rrs::MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(50);
    ready.planner.SetInterpolationTime(0.5);
    ready.to(joint_pos({80, 60, 0}));
    const rrs::JointPos at = ready.step().joints;
    EXPECT_NEAR(at[1], at[0] * 0.75, 1e-9);
}

TEST_P(UncoordinatedMoveServices, RejectRapidOnConveyor) {
    PlannerSetup setup = apart(gantry_setup());
    ReadyShell ready(make(setup), joint_pos({500, 500, 300, 0, 0}));
    ready.planner.SelectMotionType(rrs::MotionType::linear);
    ready.planner.SetRapid(true);
    ready.planner.DefineConveyor(1, {1, 0, 0}, 20);
    ASSERT_EQ(ready.planner.SelectTracking(1, true), Status::RRS_SUCCESS);
    EXPECT_EQ(ready.to(joint_pos({600, 540, 300, 0, 0})), Status::RRS_MODE_NOT_SUPPORTED);
    EXPECT_EQ(message(ready.planner), "Rapids that are not interpolated cannot follow a conveyor.");
    ready.planner.SetRapid(false);
    ready.planner.SetCartesianPositionSpeed(50);
    EXPECT_EQ(ready.to(joint_pos({600, 540, 300, 0, 0})), Status::RRS_SUCCESS);
}

TEST_P(UncoordinatedMoveServices, PathEventsOccurAtToolPosition) {
    ReadyShell ready(make(apart_slides()), joint_pos({0, 0, 0}));
    ready.planner.SelectMotionType(rrs::MotionType::linear);
    ready.planner.SetRapid(true);
    ready.planner.SetInterpolationTime(2);
    ASSERT_EQ(ready.planner.DefinePathEvent(1, 1, -50), Status::RRS_SUCCESS);
    ready.to(joint_pos({100, 40, 0}));
    ready.step();
    int event = 0;
    double time_s = 0;
    ASSERT_EQ(ready.planner.GetEvent(0, event, time_s), Status::RRS_SUCCESS);
    EXPECT_NEAR(time_s, 0.55, 1e-9) << "at X50 Y40: the rest is along X alone";
}

TEST(UncoordinatedMove, LengthIsToolPathLength) {
    ReadyRapids at(apart_slides(), joint_pos({0, 0, 0}));
    at.to(joint_pos({100, 40, 0}));
    const Segment& segment = at.last();
    EXPECT_NEAR(uncoordinated_distance_mm(segment, 0.4), 35 * std::sqrt(2.0), 1e-9)
        << "both at the same speed";
    EXPECT_NEAR(segment.length_mm - uncoordinated_distance_mm(segment, 0.5), 55, 1e-9) << "X alone";
    EXPECT_NEAR(segment.length_mm, way_by_chords_mm(segment), 1e-6);
    EXPECT_NEAR(segment.path_speed_mm_s(0.25), 100 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(segment.path_speed_mm_s(0.75), 100, 1e-9);
}

TEST(UncoordinatedMove, IsLineForSingleJoint) {
    ReadyRapids at(apart_slides(), joint_pos({0, 0, 0}));
    at.to(joint_pos({0, -70, 0}));
    EXPECT_FALSE(at.last().is_uncoordinated());
    EXPECT_NEAR(at.last().duration_s, trapezoid_s(70, 100, 1000), 1e-12);
    EXPECT_EQ(at.last().length_mm, 70);
}

TEST(UncoordinatedMove, UnlimitedAccelerationGivesSharpCorner) {
    PlannerSetup setup = apart_slides();
    for (JointSetup& joint : setup.joints) joint.max_acceleration = kUnlimited;
    ReadyRapids at(setup, joint_pos({0, 0, 0}));
    at.to(joint_pos({100, 40, 0}));
    const Segment& segment = at.last();
    EXPECT_NEAR(segment.duration_s, 1, 1e-12);
    EXPECT_NEAR(segment.length_mm, 40 * std::sqrt(2.0) + 60, 1e-9);
    EXPECT_EQ(segment.at(0.7).velocity[1], 0) << "it stands";
    EXPECT_NEAR(segment.position_at(0.7)[1], 40, 1e-12);
}

// The TCP of G43.4 is controlled in feeds; in a rapid each joint moves to its target.
TEST(UncoordinatedMove, IgnoresTcpControlInRapid) {
    ReadyRapids at(apart(gantry_setup()), joint_pos({500, 500, 300, 0, 0}));
    ASSERT_EQ(at.planner.SetTipControl(true, {0, 0, -50}), Status::RRS_SUCCESS);
    ASSERT_EQ(at.to(joint_pos({600, 520, 300, 0.3, 0.2})), Status::RRS_SUCCESS);
    at.planner.flush();
    ASSERT_EQ(at.collector.segments.size(), 1U);
    EXPECT_TRUE(at.last().is_uncoordinated());
    EXPECT_EQ(at.last().end, joint_pos({600, 520, 300, 0.3, 0.2}));
}

TEST(UncoordinatedMove, RapidOverrideSlowsEachJoint) {
    PlannerSetup setup = apart_slides();
    setup.overrides = std::make_shared<const OverrideSchedule>(
        std::vector<OverrideChange>{{.at_s = 0, .to = {.rapid = 0.5}}});
    ReadyRapids at(setup, joint_pos({0, 0, 0}));
    at.planner.set_enabled_overrides({.rapid = true});
    at.to(joint_pos({100, 40, 0}));
    EXPECT_NEAR(at.last().duration_s, trapezoid_s(100, 50, 1000), 1e-9);
    ASSERT_EQ(at.last().followers().size(), 1U);
    EXPECT_NEAR(at.last().followers()[0].law.duration_s(), trapezoid_s(40, 50, 1000), 1e-9);
    EXPECT_EQ(at.last().limited_by.kind, LimitKind::rapid_override);
}

/// Returns the min time of one joint alone.
double own_time_s(const PlannerSetup& setup, int joint, double change) {
    const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
    const double jerk = setup.controller.ramps.limit_jerk ? limits.max_jerk : kUnlimited;
    return TimeLaw::between(std::abs(change), 0, 0,
                            {limits.max_speed, limits.max_acceleration, limits.deceleration(), jerk})
        .duration_s();
}

TEST(UncoordinatedMove, RandomMovesKeepLimitsAndJointsTakeMinimumTime) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> place(-300, 300);
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        PlannerSetup setup = apart(odd_setup(random));
        set_ramps(setup, random, round % 2 == 0);
        rrs::JointPos start(setup.joint_count()), target(setup.joint_count());
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            start[joint] = place(random);
            target[joint] = joint % 3 == round % 4 ? start[joint] : place(random);
        }
        ReadyRapids at(setup, start);
        ASSERT_EQ(at.to(target), Status::RRS_SUCCESS) << at.message();
        const Segment& segment = at.last();
        double longest_s = 0;
        for (int joint = 0; joint < setup.joint_count(); ++joint)
            longest_s = std::max(longest_s, own_time_s(setup, joint, target[joint] - start[joint]));
        ASSERT_NEAR(segment.duration_s, longest_s, 1e-9 * longest_s);
        for (const Follower& follower : segment.followers()) {
            const double own_s =
                own_time_s(setup, follower.joint, target[follower.joint] - start[follower.joint]);
            ASSERT_NEAR(follower.law.duration_s(), own_s, 1e-9 * own_s);
            ASSERT_NO_FATAL_FAILURE(expect_law_limits(follower.law, follower.limits));
            ASSERT_NEAR(segment.position_at(own_s * 1.0001)[follower.joint], target[follower.joint], 1e-9);
        }
        ASSERT_NO_FATAL_FAILURE(expect_law_limits(segment.master, segment.master_limits));
        const bool slow = std::all_of(
            segment.followers().begin(), segment.followers().end(),
            [&](const Follower& follower) { return follower.law.duration_s() > segment.duration_s / 10; });
        if (slow) {  // at 400 instants
            ASSERT_NO_FATAL_FAILURE(expect_smooth(segment));
        }
        ASSERT_NEAR(segment.length_mm, way_by_chords_mm(segment), 1e-6 * (1 + segment.length_mm));
    }
}

// Each joint brakes independently, and after ContinueMotion moves the remainder of its distance
// independently, too.
TEST(UncoordinatedMove, StopsAndContinuesEachJointIndependently) {
    ReadyRapids at(apart_slides(), joint_pos({0, 0, 0}));
    at.to(joint_pos({100, 40, 10}));
    at.planner.SetInterpolationTime(0.25);
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    at.planner.GetNextStep(joints, pose, elapsed_s);
    ASSERT_EQ(at.planner.StopMotion(), Status::RRS_SUCCESS);
    at.planner.GetNextStep(joints, pose, elapsed_s);
    EXPECT_NEAR(elapsed_s, 0.1, 1e-9);
    EXPECT_LT((joints - joint_pos({25, 25, 10})).norm(), 1e-9) << "Z is there";
    ASSERT_EQ(at.planner.ContinueMotion(), Status::RRS_SUCCESS);
    const Segment& standstill = at.last();
    EXPECT_NEAR(standstill.duration_s, trapezoid_s(75, 100, 1000), 1e-9);
    const double y_s = trapezoid_s(15, 100, 1000);
    EXPECT_NEAR(standstill.position_at(y_s)[1], 40, 1e-9);
    EXPECT_NEAR(standstill.position_at(y_s)[0], 25 + 100 * (y_s - 0.05), 1e-9);
    EXPECT_EQ(standstill.end, joint_pos({100, 40, 10}));
    EXPECT_NEAR(standstill.length_mm, way_by_chords_mm(standstill), 1e-6);
    ASSERT_NO_FATAL_FAILURE(expect_smooth(standstill));
}

TEST(UncoordinatedMove, StopsOfRandomMovesKeepLimits) {
    std::mt19937 random(32);
    std::uniform_real_distribution<double> place(-300, 300), unit(0, 1);
    for (int round = 0; round < 100; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        PlannerSetup setup = apart(odd_setup(random));
        set_ramps(setup, random, round % 2 == 0);
        rrs::JointPos start(setup.joint_count()), target(setup.joint_count());
        for (double& value : start) value = place(random);
        for (double& value : target) value = place(random);
        ReadyRapids at(setup, start);
        at.to(target);
        for (int stops = 0; stops < 3; ++stops) {
            at.planner.SetInterpolationTime(std::max(1e-3, unit(random) * at.planner.time_s() / 2));
            rrs::JointPos joints;
            rrs::CartPos pose;
            double elapsed_s = 0;
            at.planner.GetNextStep(joints, pose, elapsed_s);
            ASSERT_EQ(at.planner.StopMotion(), Status::RRS_SUCCESS);
            at.planner.ContinueMotion();
        }
        at.planner.flush();
        rrs::JointPos current = start;
        for (const Segment& segment : at.collector.segments) {
            ASSERT_LT((segment.start - current).norm(), 1e-9);
            current = segment.end;
            ASSERT_NO_FATAL_FAILURE(expect_law_limits(segment.master, segment.master_limits));
            for (const Follower& follower : segment.followers())
                ASSERT_NO_FATAL_FAILURE(expect_law_limits(follower.law, follower.limits));
            ASSERT_NEAR(segment.length_mm, way_by_chords_mm(segment), 1e-6 * (1 + segment.length_mm));
        }
        ASSERT_EQ(current, target);
    }
}

}  // namespace
}  // namespace gsim::motion::apart_move_test
