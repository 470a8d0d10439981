// StopMotion and ContinueMotion with a look-ahead that rounds corners within a tolerance.

#include "tests/motion/linuxcnc/linuxcnc_run.h"
#include "tests/motion/motion_checks.h"
#include "tests/motion/stop_path.h"

namespace gsim::motion::blend_stop_test {
namespace {

using rrs::CornerRule;
using rrs::Status;

class BlendStop : public testing::TestWithParam<CornerRule> {
  protected:
    double number(double scale) { return std::uniform_real_distribution<double>(-scale, scale)(random); }
    bool chance(double share) { return std::bernoulli_distribution(share)(random); }

    PlannerSetup setup() {
        PlannerSetup setup = fast_machine();
        const kinematics::DhLink slide{.kind = rrs::JointKind::prismatic};
        const kinematics::DhLink turn{.kind = rrs::JointKind::revolute};
        setup.kinematics = std::make_shared<kinematics::ChainKinematics>(
            kinematics::DhChain(rrs::CartPos::Identity(), std::vector{slide, slide, slide, turn, turn},
                                rrs::CartPos::Identity()));
        for (JointSetup& joint : setup.joints) joint.max_acceleration *= std::exp(number(1));
        set_ramps(setup, random, GetParam() == CornerRule::smooth_blend);
        rrs::ControllerRules& controller = setup.controller;
        controller.planner = rrs::PlannerKind::look_ahead;
        controller.corners.continuous = GetParam();
        controller.corners.exact_path = CornerRule::stop;
        controller.ramps.centripetal_share = 0.866;
        controller.blocks.look_ahead = std::uniform_int_distribution<std::size_t>(1, 40)(random);
        setup.queue_capacity = 2000;
        return setup;
    }

    struct Program {
        std::vector<rrs::JointPos> targets;
        double tolerance_mm;
        double speed_mm_s;
        bool arcs;  ///< Half a circle after each third target, 6 mm along X.
    };
    Program program() {
        Program program{{}, std::exp(2 * number(1) - 2), 10 + 90 * (1 + number(1)), chance(0.3)};
        const double size = chance(0.3) ? 0.3 : 30;
        const bool turns = chance(0.6);
        for (int i = 0; i < 10; ++i) {
            rrs::JointPos target = rrs::JointPos::Zero(5);
            for (int joint = 0; joint < 3; ++joint) target[joint] = number(size);
            if (turns) target[3] = number(0.02 * size);
            program.targets.push_back(target);
        }
        return program;
    }
    static rrs::JointPos enqueue(const Program& program, ReadyPlanner& ready) {
        ready.planner.SelectMotionType(rrs::MotionType::linear);
        ready.planner.SetCartesianPositionSpeed(program.speed_mm_s);
        ready.planner.SetPathMode(rrs::PathMode::continuous, program.tolerance_mm, 0);
        rrs::JointPos at;
        for (const rrs::JointPos& target : program.targets) {
            EXPECT_EQ(ready.to(target), Status::RRS_SUCCESS) << ready.message();
            at = target;
            if (!program.arcs || ready.id % 3 != 0) continue;
            at[0] += 6;
            EXPECT_EQ(
                ready.arc_to(at, target.head<3>() + Eigen::Vector3d(3, 0, 0), Eigen::Vector3d::UnitZ(), kPi),
                Status::RRS_SUCCESS);
        }
        return at;
    }

    std::mt19937 random{51};
};

TEST_P(BlendStop, KeepsPathAndLimitsAtAnyTime) {
    int blends = 0;
    for (int round = 0; round < 20; ++round) {
        const PlannerSetup machine = setup();
        const Program moves = program();
        ReadyPlanner planned(machine, rrs::JointPos::Zero(5));
        const rrs::JointPos end = enqueue(moves, planned);
        planned.planner.flush();
        const std::vector<Segment>& plan = planned.collector.segments;
        ReadyPlanner ready(machine, rrs::JointPos::Zero(5));
        enqueue(moves, ready);
        ready.planner.SetInterpolationTime(std::max(plan.back().end_s() / 200, 0.0005));
        for (int stops = 0; stops < 3; ++stops) {
            const int steps = std::uniform_int_distribution<int>(0, 90)(random);
            for (int i = 0; i < steps; ++i) advance_step(ready.planner);
            ASSERT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
            const rrs::JointPos stands = run_to_rest(ready.planner);
            ASSERT_EQ(advance_step(ready.planner).joints, stands);
            ASSERT_EQ(ready.planner.ContinueMotion(), Status::RRS_SUCCESS);
        }
        ASSERT_LT((run_to_rest(ready.planner) - end).norm(), 1e-9);
        const std::vector<Segment>& segments = ready.collector.segments;
        ASSERT_NO_FATAL_FAILURE(expect_planned_way(segments, plan, machine)) << "round " << round;
        for (const Segment& segment : segments) {
            blends += segment.superimposed != nullptr;
            ASSERT_NO_FATAL_FAILURE(expect_speeds(segment, machine)) << "round " << round;
            if (segment.superimposed) continue;
            ASSERT_NO_FATAL_FAILURE(expect_law_limits(segment.master, segment.master_limits))
                << "round " << round;
        }
    }
    EXPECT_GT(blends, 100);
}

INSTANTIATE_TEST_SUITE_P(Both, BlendStop,
                         testing::Values(CornerRule::parabolic_blend, CornerRule::smooth_blend),
                         [](const auto& tested) {
                             return tested.param == CornerRule::smooth_blend ? "Smooth" : "Parabolic";
                         });

}  // namespace
}  // namespace gsim::motion::blend_stop_test
