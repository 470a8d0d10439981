// Targets in frames of a cell (SelectWorkFrames).

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/simulator/posed.h"

namespace gsim::simulation::work_frames_test {
namespace {

using Eigen::Vector3d;
using kinematics::pose_from_rpy;
using rrs::CartPos;
using rrs::JointPos;
using rrs::Status;
using testing::HasSubstr;

const CartPos kStand = pose_from_rpy({.x_mm = 30, .y_mm = -20, .roll_rad = M_PI / 2});
const CartPos kFixture =
    kStand *
    pose_from_rpy({.x_mm = 10, .z_mm = -400, .roll_rad = 20 * M_PI / 180, .pitch_rad = -10 * M_PI / 180});
const CartPos kTurned = pose_from_rpy({.roll_rad = 40 * M_PI / 180});
const CartPos kNozzle = kTurned * pose_from_rpy({.x_mm = 5, .z_mm = -80});

class WorkFrames : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Machines, WorkFrames, testing::Values("af5", "mill-head-table", "arm6"),
                         [](const auto& machine) {
                             std::string name = machine.param;
                             std::erase(name, '-');
                             return name;
                         });

// A tool frame without an offset and an object frame: the motion is that of the targets transformed by hand.
TEST_P(WorkFrames, MotionEqualsThatOfTransformedTargets) {
    Posed framed(GetParam());
    Posed plain(GetParam());
    const bool in_work = plain.cell.work_frames("tool", "stand").has_value();
    const CartPos object = in_work ? kFixture : CartPos::Identity();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset_mm(-60, 60);
    framed.start();
    plain.start();
    ASSERT_EQ(framed.planner.SelectWorkFrames("turned tool", in_work ? "fixture 1" : "work"),
              Status::RRS_SUCCESS);
    const CartPos current = plain.setup.kinematics->forward(plain.planner.position());
    for (int i = 0; i < 5; ++i) {
        CartPos target = current;  // of the tool centre point in the work frame
        target.translation() += Vector3d(offset_mm(random), offset_mm(random), offset_mm(random));
        ASSERT_EQ(plain.to(target), Status::RRS_SUCCESS) << plain.message();
        ASSERT_EQ(framed.to(object.inverse() * target * kTurned), Status::RRS_SUCCESS) << framed.message();
    }
    for (;;) {
        const Posed::Step a = framed.step();
        const Posed::Step b = plain.step();
        ASSERT_EQ(a.status, b.status);
        ASSERT_LT((a.joints - b.joints).cwiseAbs().maxCoeff(), 1e-6);
        ASSERT_TRUE((object * a.pose).isApprox(b.pose * kTurned, 1e-8));
        if (a.status == Status::RRS_NEED_MORE_DATA) break;
    }
}

// The origin of a tool frame moves straight and evenly in the object frame, though the tool turns.
TEST_P(WorkFrames, ToolFrameFollowsProgrammedPath) {
    Posed robot(GetParam());
    robot.start();
    const bool in_work = robot.cell.work_frames("tool", "stand").has_value();
    const char* object = in_work ? "fixture 1" : "work";
    ASSERT_EQ(robot.planner.SelectWorkFrames("nozzle tip", object), Status::RRS_SUCCESS) << robot.message();
    const CartPos from = robot.step().pose;
    CartPos to;
    {  // a pose that the machine reaches: that of other joints
        JointPos joints = robot.planner.position();
        for (int i = 0; i < joints.size(); ++i) joints[i] += joints.size() == 6 || i >= 3 ? 0.2 : -50.0;
        ASSERT_EQ(robot.planner.GetForwardKinematics(joints, to), Status::RRS_SUCCESS);
    }
    ASSERT_EQ(robot.to(to), Status::RRS_SUCCESS) << robot.message();
    const Vector3d displacement = (to.translation() - from.translation()).normalized();
    Posed::Step step;
    for (step = robot.step(); step.status == Status::RRS_SUCCESS; step = robot.step()) {
        const Vector3d gone = step.pose.translation() - from.translation();
        ASSERT_LT((gone - displacement * displacement.dot(gone)).norm(),
                  robot.setup.controller.coordination.tcp_tolerance_mm);
    }
    EXPECT_EQ(step.status, Status::RRS_TARGET_REACHED);
    EXPECT_TRUE(step.pose.isApprox(to, 1e-6));
    JointPos solved;
    ASSERT_EQ(robot.planner.GetInverseKinematics(to, step.joints, solved), Status::RRS_SUCCESS);
    EXPECT_LT((solved - step.joints).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(CellWorkFrames, MovedFixtureMovesTargets) {
    Posed robot("af5");
    robot.start();
    ASSERT_EQ(robot.planner.SelectWorkFrames("tool", "fixture 1"), Status::RRS_SUCCESS);
    const CartPos target = robot.step().pose;
    const JointPos before = robot.planner.position();
    CartPos moved = kStand;
    moved.translation() += Vector3d(40, 7, -3);
    ASSERT_EQ(robot.planner.ModifyCellFrame("stand", moved), Status::RRS_SUCCESS) << robot.message();
    ASSERT_EQ(robot.to(target), Status::RRS_SUCCESS) << robot.message();
    const CartPos there = robot.setup.kinematics->forward(robot.planner.position());
    const CartPos was = robot.setup.kinematics->forward(before);
    EXPECT_LT((there.translation() - was.translation() - Vector3d(40, 7, -3)).norm(), 1e-9);
    EXPECT_TRUE(there.linear().isApprox(was.linear(), 1e-9));
}

TEST(CellWorkFrames, ArcsAreInObjectFrame) {
    Posed robot("af5");
    robot.start();
    for (const char* tool : {"turned tool", "nozzle tip"}) {
        ASSERT_EQ(robot.planner.SelectWorkFrames(tool, "fixture 1"), Status::RRS_SUCCESS);
        const CartPos from = robot.step().pose;
        const Vector3d centre = from.translation() + Vector3d(0, 50, 0);
        CartPos to = from;
        to.translation() += Vector3d(50, 50, 0);
        ASSERT_EQ(robot.planner.SetNextArcTarget(1, centre, Vector3d::UnitZ(), M_PI / 2, to, JointPos()),
                  Status::RRS_SUCCESS)
            << robot.message();
        Posed::Step step = robot.step();
        for (; step.status == Status::RRS_SUCCESS; step = robot.step())
            ASSERT_NEAR((step.pose.translation() - centre).norm(), 50, 0.02);
        EXPECT_TRUE(step.pose.isApprox(to, 1e-6));
    }
}

TEST(CellWorkFrames, RejectInvalidNames) {
    Posed robot("af5");
    robot.start();
    EXPECT_EQ(robot.planner.SelectWorkFrames("nozle tip", "world"), Status::RRS_UNKNOWN_FRAME);
    EXPECT_THAT(robot.message(), HasSubstr("did you mean 'nozzle tip'?"));
    EXPECT_EQ(robot.planner.SelectWorkFrames("stand", "world"), Status::RRS_INVALID_PARAMETER);
    EXPECT_THAT(robot.message(), HasSubstr("'stand' moves relative to the frame 'tool'"));
    EXPECT_EQ(robot.planner.SelectWorkFrames("tool", "X"), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(robot.planner.SelectWorkFrames("tool", "nozzle tip"), Status::RRS_INVALID_PARAMETER);
    const CartPos pose = robot.step().pose;
    EXPECT_TRUE(pose.isApprox(robot.setup.kinematics->forward(robot.planner.position()), 1e-12));
    EXPECT_EQ(robot.planner.SelectWorkFrames("tool", "base"), Status::RRS_SUCCESS);
    EXPECT_EQ(robot.planner.Reset(), Status::RRS_SUCCESS);
    EXPECT_TRUE(robot.planner.selections().frames.object.isApprox(CartPos::Identity()));
}

// If a table carries the work, objects in the world move against it.
TEST(CellWorkFrames, RejectWorldObjectIfTableCarriesWork) {
    Posed robot("mill-table-table");
    EXPECT_EQ(robot.planner.SelectWorkFrames("tool", "stand"), Status::RRS_INVALID_PARAMETER);
    EXPECT_THAT(robot.message(), HasSubstr("'work'"));
    EXPECT_EQ(robot.planner.SelectWorkFrames("tool", "work"), Status::RRS_SUCCESS);
}

TEST(CellWorkFrames, RejectSelectionWithoutCell) {
    motion::DefaultPlanner planner(make_planner_setup(sample("af5")));
    planner.Initialize();
    EXPECT_EQ(planner.SelectWorkFrames("tool", "world"), Status::RRS_SERVICE_NOT_SUPPORTED);
}

}  // namespace
}  // namespace gsim::simulation::work_frames_test
