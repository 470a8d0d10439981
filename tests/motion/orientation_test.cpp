// The great circle through the planners: direction, evenness, limits, and return values.

#include "tests/motion/machines.h"
#include "tests/motion/motion_checks.h"

namespace gsim::motion::orientation_test {
namespace {

using Eigen::Vector3d;
using rrs::Dominance;
using rrs::MotionType;
using rrs::PlannerKind;
using rrs::Status;

PlannerSetup great_circle_setup(PlannerKind kind = PlannerKind::rest_to_rest) {
    PlannerSetup setup = gantry_setup();
    setup.controller.planner = kind;
    setup.controller.coordination.orientation = rrs::OrientationRule::great_circle;
    setup.controller.corners.continuous = rrs::CornerRule::velocity_step;
    return setup;
}

Vector3d direction(const PlannerSetup& setup, const rrs::JointPos& joints) {
    return setup.kinematics->forward(joints).linear().col(2);
}

/// Expects at dense instants that the direction is as far along the great circle as the lead is along its
/// path.
void expect_great_circle(const PlannerSetup& setup, const Segment& segment) {
    const Vector3d from = direction(setup, segment.start);
    const Vector3d to = direction(setup, segment.end);
    const Vector3d normal = from.cross(to);
    const double angle = std::atan2(normal.norm(), from.dot(to));
    const Vector3d ahead = normal.cross(from).normalized();
    for (int i = 0; i <= 100; ++i) {
        const double t_s = segment.duration_s * i / 100;
        const double turned = angle * (segment.master.at(t_s).s / segment.master.length());
        const Vector3d expected_value = std::cos(turned) * from + std::sin(turned) * ahead;
        ASSERT_LT((direction(setup, segment.position_at(t_s)) - expected_value).norm(), 1e-9);
        ASSERT_LT((direction(setup, segment.at(t_s).position) - expected_value).norm(), 1e-9);
    }
}

/// Checks accelerations, and jerks as differences of these within the parts of the lead.
void expect_ramp_limits(const PlannerSetup& setup, const Segment& segment) {
    expect_joint_limits(segment, setup, 300);
    if (!setup.controller.ramps.limit_jerk) return;
    double start_s = 0;
    for (const LawSection& section : segment.master.sections()) {
        const double dt = section.duration_s / 50;
        for (int i = 0; i < 49; ++i) {
            const double t_s = start_s + dt * (i + 0.5);
            const rrs::JointPos change = segment.at(t_s + dt).acceleration - segment.at(t_s).acceleration;
            for (int joint = 3; joint < 5; ++joint) {
                ASSERT_LE(std::abs(change[joint]),
                          setup.joints[static_cast<std::size_t>(joint)].max_jerk * dt * (1 + 1e-6) + 1e-9);
            }
        }
        start_s += section.duration_s;
    }
}

class RandomPoses {
  public:
    explicit RandomPoses(unsigned seed) : random_(seed) {}
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    bool chance(double share) { return uniform(0, 1) < share; }
    /// Within the machine and on one side of the pole, some near it; now and then the tool alone turns.
    rrs::JointPos next(const rrs::JointPos& before) {
        rrs::JointPos pose =
            joint_pos({uniform(0, 1000), uniform(0, 1000), uniform(0, 600), uniform(-1.5, 1.5),
                       kPi / 2 * std::exp(-uniform(0, 1) * uniform(0, 6))});
        if (chance(0.2))
            pose.head<3>() = before.head<3>();
        else if (chance(0.1))
            pose.tail<2>() = before.tail<2>();
        return pose;
    }

  private:
    std::mt19937 random_;
};

void run_random(PlannerSetup setup, unsigned seed) {
    RandomPoses poses(seed);
    for (JointSetup& joint : setup.joints) joint.max_jerk = joint.max_acceleration * poses.uniform(2, 10);
    rrs::JointPos at = joint_pos({500, 500, 300, 0, 0.3});
    ReadyPlanner ready(setup, at);
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SelectFlybyMode(setup.controller.planner == PlannerKind::look_ahead);
    std::vector<rrs::JointPos> targets{at};
    for (int i = 0; i < 60; ++i) {
        at = poses.next(at);
        ready.planner.SetCartesianPositionSpeed(poses.uniform(1, 250));
        ready.planner.SetCartesianOrientationSpeed(poses.uniform(0.05, 3));
        ASSERT_EQ(ready.to(at), Status::RRS_SUCCESS) << ready.message();
        targets.push_back(at);
    }
    ready.planner.flush();
    std::size_t turned = 0;
    std::size_t target = 0;
    for (const Segment& segment : ready.collector.segments) {
        ASSERT_EQ(segment.start, targets[target]);
        if (segment.duration_s > 0) {
            ASSERT_EQ(segment.end, targets[++target]);
        }
        if (!segment.orientation) continue;
        ++turned;
        expect_great_circle(setup, segment);
        expect_ramp_limits(setup, segment);
        ASSERT_EQ(segment.position_at(segment.duration_s), segment.end);
        ASSERT_EQ(segment.position_at(0), segment.start);
        ASSERT_LT((segment.position_at(1e-12) - segment.start).norm(), 1e-9);
        ASSERT_LT((segment.position_at(segment.duration_s * (1 - 1e-15)) - segment.end).norm(), 1e-9);
    }
    EXPECT_GT(turned, 40u);
    EXPECT_EQ(target + 1, targets.size());
}

TEST(Orientation, RandomRestToRestMovesFollowGreatCirclesWithinLimits) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        PlannerSetup setup = great_circle_setup();
        setup.controller.ramps.limit_jerk = seed % 2 == 1;
        run_random(setup, seed);
    }
}

TEST(Orientation, RandomMovesWithLookAheadFollowGreatCirclesWithinLimits) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        PlannerSetup setup = great_circle_setup(PlannerKind::look_ahead);
        setup.controller.ramps.limit_jerk = seed % 2 == 1;
        run_random(setup, seed + 10);
    }
}

TEST(Orientation, SegmentsAreSmooth) {
    ReadyPlanner ready(great_circle_setup(), joint_pos({500, 500, 300, -1, 0.6}));
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(200);
    ASSERT_EQ(ready.to(joint_pos({900, 500, 200, 1, 0.9})), Status::RRS_SUCCESS) << ready.message();
    expect_smooth(ready.last());
    ASSERT_EQ(ready.to(joint_pos({900, 500, 200, -1, 0.3})), Status::RRS_SUCCESS) << ready.message();
    expect_smooth(ready.last());
    EXPECT_EQ(ready.last().length_mm, 0);
}

// The joints of the position on their circle, those of the head on theirs.
TEST(Orientation, FollowsGreatCircleDuringArcMove) {
    for (const PlannerKind kind : {PlannerKind::rest_to_rest, PlannerKind::look_ahead}) {
        const PlannerSetup setup = great_circle_setup(kind);
        ReadyPlanner ready(setup, joint_pos({600, 500, 300, -1, 0.6}));
        ready.planner.SetCartesianPositionSpeed(100);
        ASSERT_EQ(ready.arc_to(joint_pos({400, 500, 300, 1, 0.9}), {500, 500, 300}, Vector3d::UnitZ(), kPi),
                  Status::RRS_SUCCESS)
            << ready.message();
        const Segment& segment = ready.last();
        ASSERT_TRUE(segment.orientation);
        expect_great_circle(setup, segment);
        expect_joint_limits(segment, setup, 300);
        const rrs::JointPos middle = segment.position_at(segment.duration_s / 2);
        EXPECT_NEAR(middle[0], 500, 1e-9);
        EXPECT_NEAR(middle[1], 600, 1e-9);
    }
}

TEST(Orientation, OrientationSpeedAppliesAlongGreatCircle) {
    ReadyPlanner ready(great_circle_setup(), joint_pos({500, 500, 300, -0.5, kPi / 2}));
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    ready.planner.SetCartesianOrientationSpeed(0.01);
    const auto duration_s = [&](Dominance dominance, const rrs::JointPos& to) {
        ready.planner.SelectDominantInterpolation(dominance);
        EXPECT_EQ(ready.to(to), Status::RRS_SUCCESS) << ready.message();
        return ready.last().duration_s;
    };
    // On the equator the turning joint moves evenly: 1 rad, with the ramps of the tool's path of 200 mm.
    const auto trapezoid = [](double speed_mm_s, double acceleration_mm_s2) {
        return trapezoid_s(200, speed_mm_s, acceleration_mm_s2);
    };
    const double by_joint = kPi / 2 * 200;  // what the turning joint allows, mm/s2
    EXPECT_NEAR(duration_s(Dominance::automatic, joint_pos({700, 500, 300, 0.5, kPi / 2})),
                trapezoid(0.01 * 200, by_joint), 1e-9);
    EXPECT_NEAR(duration_s(Dominance::orientation, joint_pos({500, 500, 300, -0.5, kPi / 2})),
                trapezoid(0.01 * 200, by_joint), 1e-9);
    EXPECT_NEAR(duration_s(Dominance::position, joint_pos({700, 500, 300, 0.5, kPi / 2})),
                trapezoid(100, by_joint), 1e-9);
    ready.planner.SetCartesianOrientationSpeed(1e3);
    EXPECT_NEAR(duration_s(Dominance::orientation, joint_pos({500, 500, 300, -0.5, kPi / 2})),
                trapezoid(254, by_joint), 1e-9)
        << "the limit of the path";
}

// The nearer the circle comes to the pole, the slower: the turning joint needs 1 / sin(tilt) there.
TEST(Orientation, MovesSlowlyNearPole) {
    double before_s = 0;
    for (const double off : {0.3, 0.1, 0.01, 0.001}) {
        PlannerSetup setup = great_circle_setup();
        ReadyPlanner ready(setup, joint_pos({500, 500, 300, 0, 0.5}));
        ready.planner.SelectMotionType(MotionType::linear);
        ready.planner.SetCartesianPositionSpeed(100);
        ASSERT_EQ(ready.to(joint_pos({600, 500, 300, kPi - off, 0.5})), Status::RRS_SUCCESS)
            << ready.message();
        const Segment& segment = ready.last();
        EXPECT_GT(segment.duration_s, before_s);
        before_s = segment.duration_s;
        expect_great_circle(setup, segment);
        expect_joint_limits(segment, setup, 2001);
    }
}

TEST(Orientation, RapidAndJointMotionInterpolateJointAngles) {
    ReadyPlanner ready(great_circle_setup(), joint_pos({500, 500, 300, 0, 0}));
    const rrs::JointPos to = joint_pos({600, 500, 300, 1, 0.5});
    ASSERT_EQ(ready.to(to), Status::RRS_SUCCESS);
    EXPECT_FALSE(ready.last().orientation);
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    EXPECT_EQ(ready.to(joint_pos({500, 500, 300, 0, 0})), Status::RRS_NO_SOLUTION);
    ready.planner.SetRapid(true);
    EXPECT_EQ(ready.to(joint_pos({500, 500, 300, 0, 0})), Status::RRS_SUCCESS);
    EXPECT_FALSE(ready.last().orientation);
}

TEST(Orientation, TurnJointIsFreeIfToolIsUpright) {
    ReadyPlanner ready(great_circle_setup(), joint_pos({500, 500, 300, 0, 0}));
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    EXPECT_EQ(ready.to(joint_pos({600, 500, 300, 1, 0})), Status::RRS_SUCCESS) << ready.message();
    EXPECT_FALSE(ready.last().orientation);
    EXPECT_EQ(ready.to(joint_pos({500, 500, 300, 1, 0.5})), Status::RRS_SUCCESS) << ready.message();
    EXPECT_TRUE(ready.last().orientation);
}

TEST(Orientation, RejectsFullTurnWithoutDirectionChange) {
    ReadyPlanner ready(great_circle_setup(), joint_pos({500, 500, 300, 0, 1e-5}));
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    EXPECT_EQ(ready.to(joint_pos({500, 500, 300, 5e-5, 1e-5})), Status::RRS_SUCCESS) << ready.message();
    EXPECT_FALSE(ready.last().orientation);
    EXPECT_EQ(ready.to(joint_pos({500, 500, 300, 2 * kPi, 1e-5})), Status::RRS_NO_SOLUTION);
}

TEST(Orientation, RejectsTargetWithoutGreatCircle) {
    for (const PlannerKind kind : {PlannerKind::rest_to_rest, PlannerKind::look_ahead}) {
        const rrs::JointPos start = joint_pos({500, 500, 300, 0, kPi / 2});
        ReadyPlanner ready(great_circle_setup(kind), start);
        ready.planner.SelectMotionType(MotionType::linear);
        ready.planner.SetCartesianPositionSpeed(100);
        for (const auto& [turn, tilt] : {std::pair{kPi, kPi / 2}, {1.0, -0.4}, {1.0, 0.0}, {2 * kPi, 0.4}}) {
            EXPECT_EQ(ready.to(joint_pos({600, 500, 300, turn, tilt})), Status::RRS_NO_SOLUTION);
            EXPECT_FALSE(ready.message().empty());
            EXPECT_EQ(ready.planner.position(), start);
        }
        EXPECT_EQ(ready.to(joint_pos({600, 500, 300, 1, 0.4})), Status::RRS_SUCCESS) << ready.message();
    }
}

TEST(Orientation, RejectsPathOutsideTiltRange) {
    PlannerSetup setup = great_circle_setup();
    setup.joints[4].min = 0.3;
    ReadyPlanner ready(setup, joint_pos({500, 500, 300, -1, 0.4}));
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    EXPECT_EQ(ready.to(joint_pos({600, 500, 300, 1, 0.4})), Status::RRS_JOINT_LIMIT);
    EXPECT_EQ(ready.planner.last_error().joint, 4);
    EXPECT_NEAR(ready.planner.last_error().value, std::atan(std::tan(0.4) * std::cos(1)), 1e-12);
    ASSERT_EQ(ready.to(joint_pos({600, 500, 300, -0.5, 0.4})), Status::RRS_SUCCESS);
    EXPECT_NEAR(ready.last().joint_range(4).min, std::atan(std::tan(0.4) * std::cos(0.25)), 1e-12);
    EXPECT_EQ(ready.last().joint_range(4).max, 0.4);
}

TEST(Orientation, StoppedMotionStaysOnGreatCircleAndContinues) {
    const PlannerSetup setup = great_circle_setup(PlannerKind::look_ahead);
    const rrs::JointPos start = joint_pos({500, 500, 300, -1, 0.6});
    const rrs::JointPos end = joint_pos({900, 500, 200, 1, 0.9});
    ReadyPlanner full(setup, start);
    ReadyPlanner stopped(setup, start);
    for (ReadyPlanner* ready : {&full, &stopped}) {
        ready->planner.SelectMotionType(MotionType::linear);
        ready->planner.SetCartesianPositionSpeed(200);
        ASSERT_EQ(ready->to(end), Status::RRS_SUCCESS);
    }
    const Segment path = full.last();
    stopped.planner.SetInterpolationTime(path.duration_s / 3);
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    stopped.planner.GetNextStep(joints, pose, elapsed_s);
    ASSERT_EQ(stopped.planner.StopMotion(), Status::RRS_SUCCESS);
    ASSERT_EQ(stopped.planner.ContinueMotion(), Status::RRS_SUCCESS);
    stopped.planner.flush();
    ASSERT_GE(stopped.collector.segments.size(), 3u);
    expect_joined(stopped.collector.segments);
    const OrientationArc& circle = *path.orientation;
    for (const Segment& segment : stopped.collector.segments) {
        expect_great_circle(setup, segment);
        expect_joint_limits(segment, setup);
        for (int i = 0; i <= 20; ++i) {
            const rrs::JointPos at = segment.position_at(segment.duration_s * i / 20);
            const double share = (at[0] - start[0]) / (end[0] - start[0]);
            const HeadAngles expected_value = circle.at(share * circle.length_rad()).angles;
            ASSERT_NEAR(at[3], expected_value.turn, 1e-9);
            ASSERT_NEAR(at[4], expected_value.tilt, 1e-9);
        }
    }
    EXPECT_EQ(stopped.collector.segments.back().end, end);
}

TEST(Orientation, RejectsModeUnsupportedByMachineOrController) {
    const auto expected_status = [](const PlannerSetup& setup) {
        DefaultPlanner planner(setup);
        planner.Initialize();
        return planner.SelectOrientationInterpolationMode(1);
    };
    PlannerSetup setup = gantry_setup();
    EXPECT_EQ(expected_status(setup), Status::RRS_SUCCESS);
    setup.controller.planner = PlannerKind::look_ahead;
    EXPECT_EQ(expected_status(setup), Status::RRS_SUCCESS);
    setup.controller.curves.arc_chord_tolerance_mm = 0.002;
    EXPECT_EQ(expected_status(setup), Status::RRS_MODE_NOT_SUPPORTED) << "lines alone";
    std::mt19937 random(1);
    EXPECT_EQ(expected_status(odd_setup(random)), Status::RRS_MODE_NOT_SUPPORTED) << "no head";
    setup.controller.coordination.orientation = rrs::OrientationRule::great_circle;
    EXPECT_TRUE(setup.validate());
}

TEST(Orientation, SelectedModeHoldsUntilNextSelection) {
    ReadyPlanner ready(gantry_setup(), joint_pos({500, 500, 300, 0, 0.5}));
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    const auto on_circle = [&](double turn) {
        EXPECT_EQ(ready.to(joint_pos({500 + turn, 500, 300, turn, 0.5})), Status::RRS_SUCCESS);
        return ready.last().orientation != nullptr;
    };
    EXPECT_FALSE(on_circle(1));
    ready.planner.SelectOrientationInterpolationMode(1);
    EXPECT_TRUE(on_circle(0));
    EXPECT_TRUE(on_circle(1));
    ready.planner.SelectOrientationInterpolationMode(0);
    EXPECT_FALSE(on_circle(0));
}

}  // namespace
}  // namespace gsim::motion::orientation_test
