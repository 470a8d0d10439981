// For any input numbers, a planner answers, keeps a clock that is a number, and emits segments that are
// finite.

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "tests/motion/planner_under_test.h"

namespace gsim::motion::odd_values_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kOdd{0.0,
                          -0.0,
                          1.0,
                          -1.0,
                          100.0,
                          500.0,
                          0.1,
                          1e-9,
                          1e-12,
                          1e-160,
                          1e-320,
                          1e300,
                          -1e308,
                          kNan,
                          kUnlimited,
                          -kUnlimited,
                          609.6,
                          1e12,
                          6.283185307179586};

class OddValues : public AnyPlanner {
  protected:
    double odd() { return kOdd[random() % kOdd.size()]; }
    int small() { return static_cast<int>(random() % 9) - 2; }
    rrs::JointPos odd_joints() {
        rrs::JointPos q(random() % 20 == 0 ? 4 : 5);
        for (auto& value : q) value = random() % 3 == 0 ? odd() : static_cast<double>(random() % 500);
        return q;
    }
    /// Within the range of the gantry.
    rrs::JointPos corner() {
        const auto place = [this] { return static_cast<double>(random() % 500); };
        return joint_pos({place(), place(), place(), 0.1 * small(), random() % 2 == 0 ? 1e-9 : 0.0});
    }
    rrs::CartPos odd_pose() {
        rrs::CartPos pose = rrs::CartPos::Identity();
        for (int i = small(); i > 0; --i)
            pose.matrix()(static_cast<int>(random() % 4), static_cast<int>(random() % 4)) = odd();
        return pose;
    }

    void call_something(rrs::Shell& planner) {
        const std::vector<int> joints{small()};
        const std::vector<double> values{odd()};
        const auto param = static_cast<rrs::TargetParam>(random() % 2);
        rrs::JointPos joints_out;
        rrs::CartPos pose_out;
        double elapsed = 0;
        switch (random() % 24) {
            case 0: planner.SetCartesianPositionSpeed(odd()); break;
            case 1: planner.SetCartesianOrientationSpeed(odd()); break;
            case 2: planner.SetCartesianPositionAcceleration(odd()); break;
            case 3: planner.SetCartesianOrientationAcceleration(odd()); break;
            case 4: planner.SetOverrideSpeed(odd()); break;
            case 5: planner.SetOverrideAcceleration(odd()); break;
            case 6: planner.SetMotionTime(odd()); break;
            case 7: planner.SetRestParameter(odd()); break;
            case 8: planner.SetInterpolationTime(odd()); break;
            case 9: planner.SetJointSpeeds(joints, values); break;
            case 10: planner.SetJointAccelerations(joints, values); break;
            case 11: planner.SelectMotionType(static_cast<rrs::MotionType>(small())); break;
            case 12: planner.SelectTargetType(static_cast<rrs::TargetType>(random() % 2)); break;
            case 13: planner.SelectDominantInterpolation(static_cast<rrs::Dominance>(small())); break;
            case 14: planner.SetRapid(random() % 2 == 0); break;
            case 15: planner.SetNextRest(small(), odd()); break;
            case 16: planner.GetNextStep(joints_out, pose_out, elapsed); break;
            case 17:
                planner.SetNextArcTarget(1, {odd(), odd(), odd()}, Eigen::Vector3d::Unit(small() & 1), odd(),
                                         odd_pose(), odd_joints());
                break;
            case 18: planner.GetInverseKinematics(odd_pose(), odd_joints(), joints_out); break;
            case 19: planner.SetInitialPosition(odd_pose(), odd_joints(), ""); break;
            case 20: planner.SelectOrientationInterpolationMode(small()); break;
            default: planner.SetNextTarget(small(), param, odd_pose(), odd_joints(), "", 0); break;
        }
    }

    std::mt19937 random{41};
};

INSTANTIATE_TEST_SUITE_P(Ways, OddValues, all_ways(), way_name);

// No limits at all in every other session.
PlannerSetup make_setup(int session) {
    PlannerSetup setup = gantry_setup();
    if (session % 2 == 0) {
        for (JointSetup& joint : setup.joints) joint = {.kind = joint.kind};
    }
    setup.queue_capacity = 3;
    return setup;
}

class FiniteSink : public SegmentSink {
  public:
    void on_segment(const Segment& segment) override {
        ++taken;
        overlapping += segment.superimposed ? 1 : 0;
        ASSERT_TRUE(std::isfinite(segment.start_s) && segment.duration_s >= 0 && segment.duration_s <= 1e12);
        for (int i = 0; i <= 10; ++i) {
            const JointState state = segment.at(segment.duration_s * i / 10);
            ASSERT_TRUE(state.position.allFinite())
                << segment.duration_s << " s, " << segment.length_mm << " mm";
            ASSERT_TRUE(state.velocity.allFinite())
                << segment.duration_s << " s, " << segment.length_mm << " mm";
        }
    }
    int taken = 0;
    int overlapping = 0;
};

// Without a sink the queue is soon full; a step of a century frees it. Each session in another process starts
// such a process.
TEST_P(OddValues, StepsStayFinite) {
    const int sessions = GetParam().name == std::string_view("through_process") ? 150 : 1500;
    int reached = 0;
    for (int session = 0; session < sessions; ++session) {
        SCOPED_TRACE(testing::Message() << "session " << session);
        const auto planner = make(make_setup(session));
        planner->Initialize();
        planner->SetInitialPosition(rrs::CartPos::Identity(), joint_pos({100, 100, 100, 0, 0}), "");
        for (int i = 0; i < 60; ++i) {
            call_something(*planner);
            if (i % 4 != 3) continue;
            rrs::JointPos joints;
            rrs::CartPos pose;
            double elapsed_s = 0;
            planner->SetInterpolationTime(i % 8 == 3 ? 3e9 : 0.1);
            const rrs::Status status = planner->GetNextStep(joints, pose, elapsed_s);
            ASSERT_GE(static_cast<int>(status), 0) << message(*planner);
            ASSERT_TRUE(joints.allFinite() && pose.matrix().allFinite());
            ASSERT_TRUE(elapsed_s >= 0 && elapsed_s <= 3e9 * (1 + 1e-12));
            reached += status == rrs::Status::RRS_TARGET_REACHED ? 1 : 0;
        }
    }
    EXPECT_GT(reached, sessions * 4 / 3);
}

// In process alone: segments go to a sink.
class OddSegments : public OddValues {};
INSTANTIATE_TEST_SUITE_P(Ways, OddSegments, testing::Values(PlannerMaker{"in_process", make_in_process}),
                         way_name);

TEST_P(OddSegments, PlannerSurvivesRandomCalls) {
    int taken = 0;
    for (int session = 0; session < 6000; ++session) {
        SCOPED_TRACE(testing::Message() << "session " << session);
        FiniteSink sink;
        DefaultPlanner planner(make_setup(session), &sink);
        planner.Initialize();
        planner.SetInitialPosition(rrs::CartPos::Identity(), joint_pos({100, 100, 100, 0, 0}), "");
        for (int i = 0; i < 60; ++i) call_something(planner);
        planner.flush();
        taken += sink.taken;
        ASSERT_TRUE(std::isfinite(planner.time_s()));
        ASSERT_TRUE(planner.position().allFinite());
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(taken, 10'000);
}

// Rounded corners, and stops that wait for a position loop.
TEST_P(OddSegments, RoundedCornersSurviveRandomCalls) {
    int overlapping = 0;
    for (int session = 0; session < 1000; ++session) {
        SCOPED_TRACE(testing::Message() << "session " << session);
        PlannerSetup setup = make_setup(session);
        setup.controller.planner = rrs::PlannerKind::look_ahead;
        setup.controller.corners.continuous =
            session % 4 < 2 ? rrs::CornerRule::parabolic_blend : rrs::CornerRule::smooth_blend;
        setup.controller.ramps.limit_jerk = session % 5 < 2;
        setup.controller.position_loop.gain_1_s = 30;
        FiniteSink sink;
        DefaultPlanner planner(setup, &sink);
        planner.Initialize();
        planner.SetInitialPosition(rrs::CartPos::Identity(), joint_pos({100, 100, 100, 0, 0}), "");
        for (int i = 0; i < 60; ++i) {
            call_something(planner);
            if (i % 10 == 0) planner.SetPathMode(static_cast<rrs::PathMode>(random() % 3), odd(), 0);
            planner.SelectMotionType(rrs::MotionType::linear);
            planner.SelectTargetType(rrs::TargetType::joint);
            planner.SetNextTarget(i, rrs::TargetParam::end, rrs::CartPos::Identity(), corner(), "", 0);
        }
        planner.flush();
        overlapping += sink.overlapping;
        ASSERT_TRUE(std::isfinite(planner.time_s()));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(overlapping, 100);
}

}  // namespace
}  // namespace gsim::motion::odd_values_test
