// StopMotion and ContinueMotion with the planner of LinuxCNC: corners that are rounded by blend arcs, or by
// two motions at once.

#include "tests/motion/linuxcnc/linuxcnc_run.h"
#include "tests/motion/motion_checks.h"
#include "tests/motion/stop_path.h"

namespace gsim::motion::linuxcnc_stop_test {
namespace {

using rrs::Status;

PlannerSetup linuxcnc_setup() {
    PlannerSetup setup = fast_machine();
    const kinematics::DhLink slide{.kind = rrs::JointKind::prismatic};
    const kinematics::DhLink turn{.kind = rrs::JointKind::revolute};
    setup.kinematics = std::make_shared<kinematics::ChainKinematics>(kinematics::DhChain(
        rrs::CartPos::Identity(), std::vector{slide, slide, slide, turn, turn}, rrs::CartPos::Identity()));
    setup.controller.planner = rrs::PlannerKind::linuxcnc;
    setup.controller.position_loop.servo_period_s = 0.001;
    setup.queue_capacity = 2000;
    return setup;
}

struct Program {
    std::vector<rrs::JointPos> targets;
    double tolerance_mm = 0;
    double speed_mm_s = 100;
    bool arcs = false;  ///< Half a circle after each target, 6 mm along X.

    rrs::JointPos end() const { return arcs ? behind_arc(targets.back()) : targets.back(); }
    static rrs::JointPos behind_arc(const rrs::JointPos& target) {
        return target + 6 * rrs::JointPos::Unit(target.size(), 0);
    }
};

Program random_program(std::mt19937& random, bool turns) {
    std::uniform_real_distribution<double> place(-30, 30), angle(-0.5, 0.5);
    Program program;
    const int count = std::uniform_int_distribution<int>(3, 14)(random);
    const double size = std::bernoulli_distribution(0.3)(random) ? 0.1 : 1;
    for (int i = 0; i < count; ++i) {
        rrs::JointPos target = rrs::JointPos::Zero(5);
        for (int joint = 0; joint < 3; ++joint) target[joint] = size * place(random);
        if (turns) target[3] = angle(random);
        program.targets.push_back(target);
    }
    if (std::bernoulli_distribution(0.5)(random)) program.tolerance_mm = 0.5;
    program.arcs = std::bernoulli_distribution(0.3)(random);
    program.speed_mm_s = std::uniform_real_distribution<double>(10, 200)(random);
    return program;
}

void enqueue(const Program& program, ReadyPlanner& ready) {
    ready.planner.SelectMotionType(rrs::MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(program.speed_mm_s);
    ready.planner.SetPathMode(rrs::PathMode::continuous, program.tolerance_mm, 0);
    for (const rrs::JointPos& target : program.targets) {
        ASSERT_EQ(ready.to(target), Status::RRS_SUCCESS) << ready.message();
        if (!program.arcs) continue;
        const Eigen::Vector3d center = target.head<3>() + Eigen::Vector3d(3, 0, 0);
        ASSERT_EQ(ready.arc_to(Program::behind_arc(target), center, Eigen::Vector3d::UnitZ(), kPi),
                  Status::RRS_SUCCESS);
    }
}

std::vector<Segment> planned(const Program& program, const PlannerSetup& setup) {
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    enqueue(program, ready);
    ready.planner.flush();
    return ready.collector.segments;
}

/// Stops three times at random instants and continues; all motion afterwards is on the planned path.
void stop_and_go(std::mt19937& random, const Program& program, const PlannerSetup& setup, int& blends) {
    const std::vector<Segment> plan = planned(program, setup);
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    DefaultPlanner& planner = ready.planner;
    enqueue(program, ready);
    planner.SetInterpolationTime(std::max(plan.back().end_s() / 200, 0.0005));
    for (int stops = 0; stops < 3; ++stops) {
        const int steps = std::uniform_int_distribution<int>(0, 120)(random);
        for (int i = 0; i < steps; ++i) advance_step(planner);
        ASSERT_EQ(planner.StopMotion(), Status::RRS_SUCCESS);
        const rrs::JointPos stands = run_to_rest(planner);
        ASSERT_EQ(advance_step(planner).joints, stands);
        ASSERT_EQ(planner.ContinueMotion(), Status::RRS_SUCCESS);
    }
    ASSERT_LT((run_to_rest(planner) - program.end()).norm(), 1e-9);

    const std::vector<Segment>& segments = ready.collector.segments;
    for (const Segment& segment : segments) blends += segment.superimposed != nullptr;
    expect_planned_way(segments, plan, setup);
}

TEST(LinuxcncStop, KeepsPathAndLimitsAtAnyTime) {
    std::mt19937 random(31);
    int blends = 0;
    for (int round = 0; round < 60; ++round) {
        const Program program = random_program(random, round % 3 != 0);
        stop_and_go(random, program, linuxcnc_setup(), blends);
        if (testing::Test::HasFatalFailure()) FAIL() << "round " << round;
    }
    EXPECT_GT(blends, 300);
}

/// 100 mm along X, then along Y, round the corner as far as it comes: both moves have half of the
/// acceleration there, and the other half brakes.
TEST(LinuxcncStop, StopsQuicklyInBlend) {
    PlannerSetup setup = linuxcnc_setup();
    ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
    enqueue({.targets = {joint_pos({100, 0, 0, 0.1, 0}), joint_pos({100, 100, 0, 0.2, 0})}}, ready);
    ready.planner.SetInterpolationTime(0.001);
    double speed = 0;
    rrs::JointPos before = rrs::JointPos::Zero(5);
    for (rrs::JointPos at = before; at[1] < 1; before = std::exchange(at, advance_step(ready.planner).joints))
        speed = (at - before).norm() / 0.001;
    ASSERT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
    ready.planner.SetInterpolationTime(10);
    const TakenStep stopped = advance_step(ready.planner);
    EXPECT_LT(stopped.elapsed_s, 2 * speed / 245);
    EXPECT_LT(stopped.joints[1], 50);
    EXPECT_LT(stopped.joints[0], 100);
    EXPECT_EQ(ready.planner.CancelMotion(), Status::RRS_SUCCESS);
    ASSERT_EQ(ready.to(rrs::JointPos::Zero(5)), Status::RRS_SUCCESS) << ready.message();
    EXPECT_EQ(run_to_rest(ready.planner), rrs::JointPos::Zero(5));
    expect_smooth_joins(ready.collector.segments, 1e-5);
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_stop_test
