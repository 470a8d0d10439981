// The machine's own frames, which programs may change: ModifyCellFrame of "tool" and "base".

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/kinematics/chain.h"
#include "runtime/simulator/simulator.h"
#include "tests/runtime/simulator/posed.h"

namespace gsim::simulation::machine_frames_test {
namespace {

using Eigen::Vector3d;
using kinematics::pose_from_rpy;
using rrs::CartPos;
using rrs::JointPos;
using rrs::Status;
using testing::AllOf;
using testing::HasSubstr;

const CartPos kDistanceFactors = pose_from_rpy({.x_mm = 12, .y_mm = -7, .z_mm = -45, .roll_rad = 0.3});
const CartPos kElsewhere = pose_from_rpy({.x_mm = 80, .y_mm = -60, .z_mm = 25, .roll_rad = 0.5});

const kinematics::Chain& chain(const Posed& robot) {
    return robot.setup.kinematics->chain();
}

CartPos file_tool(const Posed& robot) {
    return chain(robot).tool_side().end;
}

CartPos file_base(const Posed& robot) {
    return chain(robot).tool_side().base;
}

/// Returns the TCP of the file in the world, from the joints alone, with the machine at the file's position.
CartPos tool_in_world(const Posed& robot, const JointPos& joints) {
    return chain(robot).tool_frames(joints).back();
}

JointPos other_joints(const Posed& robot) {
    JointPos joints = robot.planner.position();
    for (int i = 0; i < joints.size(); ++i) {
        const bool turns = chain(robot).kind(i) == rrs::JointKind::revolute;
        joints[i] += turns ? 0.15 : -20.0;
    }
    return joints;
}

class MachineFrames : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Machines, MachineFrames, testing::Values("af5", "mill-head-table", "arm6"),
                         [](const auto& machine) {
                             std::string name = machine.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST_P(MachineFrames, ChangedToolReachesTargetsWithItsTcp) {
    Posed robot(GetParam());
    robot.start();
    const JointPos expected_value = other_joints(robot);
    const CartPos target = robot.setup.kinematics->forward(expected_value) * kDistanceFactors;
    ASSERT_EQ(robot.planner.ModifyCellFrame("tool", file_tool(robot) * kDistanceFactors), Status::RRS_SUCCESS)
        << robot.message();
    const CartPos from = robot.step().pose;
    EXPECT_TRUE(
        from.isApprox(robot.setup.kinematics->forward(robot.planner.position()) * kDistanceFactors, 1e-9));
    ASSERT_EQ(robot.to(target), Status::RRS_SUCCESS) << robot.message();
    const Vector3d displacement = (target.translation() - from.translation()).normalized();
    Posed::Step step;
    for (step = robot.step(); step.status == Status::RRS_SUCCESS; step = robot.step()) {
        const Vector3d tcp = (robot.setup.kinematics->forward(step.joints) * kDistanceFactors).translation();
        ASSERT_LT((step.pose.translation() - tcp).norm(), 1e-9);
        const Vector3d gone = tcp - from.translation();
        ASSERT_LT((gone - displacement * displacement.dot(gone)).norm(),
                  robot.setup.controller.coordination.tcp_tolerance_mm);
    }
    EXPECT_TRUE(tool_in_world(robot, step.joints).isApprox(tool_in_world(robot, expected_value), 1e-6));
}

// A work frame that no axes carry stays in the world: the tool in the world, by the displaced chain, is at
// the target. A work frame that axes carry moves with the machine, and its joints do not change.
TEST_P(MachineFrames, MovedBaseReachesTargets) {
    Posed robot(GetParam());
    robot.start();
    const bool work_is_moved = !chain(robot).work_side().links.empty();
    const JointPos expected_value = other_joints(robot);
    const CartPos moved = kElsewhere * file_base(robot);
    const CartPos work = chain(robot).work_side().base * chain(robot).work_side().end;
    const CartPos target = work_is_moved ? robot.setup.kinematics->forward(expected_value)
                                         : work.inverse() * kElsewhere * tool_in_world(robot, expected_value);
    ASSERT_EQ(robot.planner.ModifyCellFrame("base", moved), Status::RRS_SUCCESS) << robot.message();
    ASSERT_EQ(robot.to(target), Status::RRS_SUCCESS) << robot.message();
    EXPECT_TRUE(
        tool_in_world(robot, robot.planner.position()).isApprox(tool_in_world(robot, expected_value), 1e-6));
    Posed::Step step = robot.step();
    while (step.status == Status::RRS_SUCCESS) step = robot.step();
    EXPECT_TRUE(step.pose.isApprox(target, 1e-6));
    CartPos there;
    ASSERT_EQ(robot.planner.GetCellFrame("base", there), Status::RRS_SUCCESS);
    EXPECT_TRUE(there.isApprox(moved));
}

// Both at once, and a fixture as object frame: one chain of transforms.
TEST(MachineFrames, BaseToolAndFixtureFormOneChain) {
    Posed robot("arm6");
    robot.start();
    ASSERT_EQ(robot.planner.SelectWorkFrames("tool", "fixture 1"), Status::RRS_SUCCESS);
    const JointPos expected_value = other_joints(robot);
    ASSERT_EQ(robot.planner.ModifyCellFrame("base", kElsewhere * file_base(robot)), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.ModifyCellFrame("tool", file_tool(robot) * kDistanceFactors),
              Status::RRS_SUCCESS);
    const CartPos fixture =
        robot.cell.cell().frames.pose_in_link(*robot.cell.cell().frames.find("fixture 1"));
    const CartPos target =
        fixture.inverse() * kElsewhere * tool_in_world(robot, expected_value) * kDistanceFactors;
    ASSERT_EQ(robot.to(target), Status::RRS_SUCCESS) << robot.message();
    EXPECT_TRUE(
        tool_in_world(robot, robot.planner.position()).isApprox(tool_in_world(robot, expected_value), 1e-6));
    CartPos reported;
    ASSERT_EQ(robot.planner.GetForwardKinematics(expected_value, reported), Status::RRS_SUCCESS);
    EXPECT_TRUE(reported.isApprox(target, 1e-9));
}

// Frames attached to the base move along: seen from the machine they are unchanged.
TEST(MachineFrames, TargetsInBaseFrameMoveWithBase) {
    Posed robot("arm6");
    robot.start();
    ASSERT_EQ(robot.planner.SelectWorkFrames("tool", "base"), Status::RRS_SUCCESS);
    const CartPos before = robot.step().pose;
    ASSERT_EQ(robot.planner.ModifyCellFrame("base", kElsewhere), Status::RRS_SUCCESS);
    EXPECT_TRUE(robot.step().pose.isApprox(before, 1e-9));
}

TEST(MachineFrames, PendingMotionKeepsPlannedFrames) {
    Posed robot("af5");
    robot.start();
    const CartPos current = robot.setup.kinematics->forward(robot.planner.position());
    CartPos target = current;
    target.translation().x() += 50;
    ASSERT_EQ(robot.to(target), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.ModifyCellFrame("tool", file_tool(robot) * kDistanceFactors),
              Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.ModifyCellFrame("base", kElsewhere * file_base(robot)), Status::RRS_SUCCESS);
    Posed::Step step = robot.step();
    for (; step.status == Status::RRS_SUCCESS; step = robot.step())
        ASSERT_TRUE(step.pose.isApprox(robot.setup.kinematics->forward(step.joints), 1e-12));
    EXPECT_EQ(step.status, Status::RRS_TARGET_REACHED);
    EXPECT_TRUE(step.pose.isApprox(target, 1e-9));
    step = robot.step();
    EXPECT_EQ(step.status, Status::RRS_NEED_MORE_DATA);
    const CartPos work = chain(robot).work_side().base * chain(robot).work_side().end;
    const CartPos moved = work.inverse() * kElsewhere * tool_in_world(robot, step.joints) * kDistanceFactors;
    EXPECT_TRUE(step.pose.isApprox(moved, 1e-9));
}

TEST(MachineFrames, RejectOtherMachineFramesAndInvalidPoses) {
    Posed robot("af5");
    robot.start();
    for (const char* name : {"X", "world", "work"}) {
        EXPECT_EQ(robot.planner.ModifyCellFrame(name, kDistanceFactors), Status::RRS_INVALID_PARAMETER)
            << name;
        EXPECT_THAT(robot.message(),
                    AllOf(HasSubstr("'" + std::string(name) + "'"), HasSubstr("only 'tool' and 'base'")));
    }
    CartPos bent = kDistanceFactors;
    bent.linear()(0, 0) += 0.1;
    for (const char* name : {"tool", "base"})
        EXPECT_EQ(robot.planner.ModifyCellFrame(name, bent), Status::RRS_INVALID_PARAMETER) << name;
    const CartPos pose = robot.step().pose;
    EXPECT_TRUE(pose.isApprox(robot.setup.kinematics->forward(robot.planner.position()), 1e-12));
}

TEST(MachineFrames, RejectChangeDuringConveyorTracking) {
    Posed robot("af5");
    robot.start();
    ASSERT_EQ(robot.planner.DefineConveyor(1, Vector3d::UnitX(), 10), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.SelectTracking(1, true), Status::RRS_SUCCESS) << robot.message();
    EXPECT_EQ(robot.planner.ModifyCellFrame("base", kElsewhere), Status::RRS_INVALID_PARAMETER);
    EXPECT_THAT(robot.message(), HasSubstr("while a conveyor is tracked"));
}

// A stop would leave a part of the motion, or all, that was planned before for the time after.
TEST(MachineFrames, RejectChangeWhileStoppedAndStopAfterChange) {
    Posed robot("af5");
    robot.start();
    CartPos target = robot.step().pose;
    target.translation().x() += 50;
    ASSERT_EQ(robot.to(target), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.step().status, Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.StopMotion(), Status::RRS_SUCCESS);
    EXPECT_EQ(robot.planner.ModifyCellFrame("base", kElsewhere), Status::RRS_INVALID_PARAMETER);
    EXPECT_THAT(robot.message(), HasSubstr("while a motion is stopped"));
    ASSERT_EQ(robot.planner.ContinueMotion(), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.ModifyCellFrame("base", kElsewhere * file_base(robot)), Status::RRS_SUCCESS);
    EXPECT_EQ(robot.planner.StopMotion(), Status::RRS_MODE_NOT_SUPPORTED);
    EXPECT_THAT(robot.message(), HasSubstr("'tool' or 'base' has been changed after the current motion"));
    Posed::Step step = robot.step();
    while (step.status == Status::RRS_SUCCESS) step = robot.step();
    EXPECT_TRUE(step.pose.isApprox(target, 1e-9));
    EXPECT_EQ(robot.planner.StopMotion(), Status::RRS_SUCCESS);
}

// A conveyor runs on its path in the world, wherever the machine is. If the machine is turned by 90 degrees
// about the vertical, it follows a belt along the world's X with its other slide.
TEST(MachineFrames, FollowConveyorFromMovedBase) {
    Posed robot("af5");
    robot.start();
    const CartPos turned = pose_from_rpy({.roll_rad = M_PI / 2});
    ASSERT_EQ(robot.planner.ModifyCellFrame("base", turned * file_base(robot)), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.DefineConveyor(1, Vector3d::UnitX(), 10), Status::RRS_SUCCESS);
    ASSERT_EQ(robot.planner.SelectTracking(1, true), Status::RRS_SUCCESS) << robot.message();
    const JointPos from = robot.planner.position();
    ASSERT_EQ(robot.planner.SetNextRest(2, 2), Status::RRS_SUCCESS) << robot.message();
    robot.planner.SelectTracking(1, false);
    const auto tcp = [&](const JointPos& joints) -> Vector3d {
        return robot.setup.kinematics->forward(joints).translation();
    };
    const Vector3d gone = turned.linear() * (tcp(robot.planner.position()) - tcp(from));
    EXPECT_GT(gone.x(), 20);
    EXPECT_NEAR(gone.y(), 0, 1e-9);
}

// Under TCP control the changed TCP stays at its position while the head turns.
TEST(MachineFrames, TcpControlUsesChangedTcp) {
    const machine::Machine machine = sample("af5");
    Simulator simulator(machine, {});
    CellMonitor cell(cell::read_cell(kFrames, "frames.toml", machine).value(), machine);
    simulator.set_cell(cell);
    const auto kinematics = machine::make_kinematics(machine);
    LineMove move;
    move.kind = MoveKind::rapid;
    move.target = simulator.position().axes();
    move.target.head(3) += Vector3d(600, 600, 300);
    ASSERT_TRUE(simulator.moves().enqueue(move));
    ASSERT_TRUE(simulator.tcp_control().set(Vector3d(0, 0, 0), {}));
    const CartPos shift = pose_from_rpy({.z_mm = -60});
    ASSERT_EQ(simulator.cell().modify_frame("tool", kinematics->chain().tool_side().end * shift),
              Status::RRS_SUCCESS);
    EXPECT_TRUE(simulator.position().axes().isApprox(move.target, 1e-9)) << simulator.position().axes();
    const CartPos before = kinematics->forward(simulator.motion().source().position()) * shift;
    move.target[3] += 40;
    move.target[4] += 30;
    ASSERT_TRUE(simulator.moves().enqueue(move)) << simulator.outcome().alarm()->message;
    const CartPos after = kinematics->forward(simulator.motion().source().position()) * shift;
    EXPECT_GT((after.linear() - before.linear()).norm(), 0.1);
    EXPECT_LT((after.translation() - before.translation()).norm(), 1e-6);
}

}  // namespace
}  // namespace gsim::simulation::machine_frames_test
