// Objects of a cell that move independently: on conveyors, or moved by the program.

#include "collision/cell/frame_trajectory.h"

#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "collision/monitor/clearance_monitor.h"
#include "tests/collision/meshes.h"
#include "tests/collision/segments.h"

namespace gsim::cell::carrier_test {
namespace {

using Eigen::Vector3d;
using rrs::CartPos;

CartPos at(double x, double y = 0, double z = 0) {
    return CartPos(Eigen::Translation3d(x, y, z));
}

TEST(UniformMotion, MovesEvenlyBetweenPoses) {
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        const CartPos from = random_pose(random, 100);
        const CartPos to = random_pose(random, 100);
        const UniformMotion uniform_motion = uniform_motion_between(from, to, 3, 7);
        EXPECT_TRUE(uniform_motion.at(3).isApprox(from, 1e-12));
        EXPECT_TRUE(uniform_motion.at(7).isApprox(to, 1e-9));
        const CartPos half = from.inverse() * uniform_motion.at(5);
        const CartPos full_rotation = from.inverse() * to;
        EXPECT_TRUE((half.linear() * half.linear()).isApprox(full_rotation.linear(), 1e-9));
        EXPECT_TRUE(half.translation().isApprox(full_rotation.translation() / 2, 1e-9));
    }
}

TEST(FrameTrajectory, KeepsEachDriftUntilNextOne) {
    FrameTrajectory trajectory(at(1));
    trajectory.add({.from_s = 2, .pose = at(1), .velocity_mm_s = Vector3d(10, 0, 0)});
    trajectory.add({.from_s = 4, .pose = at(50)});
    EXPECT_EQ(trajectory.at(1).translation().x(), 1);
    EXPECT_EQ(trajectory.at(3).translation().x(), 11);
    EXPECT_EQ(trajectory.at(9).translation().x(), 50);
    EXPECT_EQ(trajectory.next_change_s(0), 2);
    EXPECT_EQ(trajectory.next_change_s(2), 4);
    EXPECT_FALSE(trajectory.next_change_s(4));
    trajectory.discard_before(3);
    EXPECT_EQ(trajectory.at(3).translation().x(), 11);
    trajectory.add({.from_s = 3, .pose = at(7)});
    EXPECT_EQ(trajectory.at(9).translation().x(), 7);
    trajectory.add({.from_s = -1, .pose = at(8)});
    EXPECT_EQ(trajectory.at(0).translation().x(), 8);
}

// A ball of 10 mm at the TCP, and on the belt a plate of 0.1 mm across it. The plate is at X 1000 if the belt
// is at 0.
class ConveyorContact : public testing::Test {
  protected:
    ConveyorContact()
        : cell(read_cell(R"(
[cell]
name = "belt"
clearance_mm = 2.0
[[object]]
name = "plate"
attached_to = "belt"
shape = { box_mm = [0.1, 400.0, 400.0] }
frame = { x_mm = 1000.0, y_mm = 500.0 }
[[shape]]
name = "tip"
on = "tool"
shape = { sphere_mm = 10.0 }
)",
                         "belt.toml", af5(), kBelts)
                   .value()),
          monitor(cell, af5()) {}
    void belt(double from_s, double at_mm, double speed_mm_s) {
        cell.moving_frames[0].trajectory.add(
            {.from_s = from_s, .pose = at(at_mm), .velocity_mm_s = Vector3d(speed_mm_s, 0, 0)});
    }
    double first_contact_s() const { return monitor.contacts().empty() ? -1 : monitor.contacts()[0].t_s; }

    const std::vector<std::string> kBelts{"belt"};
    static constexpr double kGap_mm = 1000 - 0.05 - 5;  // from a TCP at X0 to the plate on a belt at 0
    Cell cell;
    ClearanceMonitor monitor;
};

TEST_F(ConveyorContact, HitsRobotAtStandstill) {
    belt(0, 0, -50);
    monitor.on_segment(standstill(0, joints(500, 500, 0), 20), false);
    EXPECT_NEAR(first_contact_s(), (kGap_mm - 500) / 50, 1e-7);
    EXPECT_EQ(monitor.contacts().size(), 1U);
    EXPECT_NEAR(monitor.contacts()[0].point_mm.x(), 505, 1e-5);
}

TEST_F(ConveyorContact, FindsThinPlateIfBothMoveFast) {
    belt(0, 0, -500);
    monitor.on_segment(line(0, joints(0, 500, 0), joints(900, 500, 0), {508}), false);
    EXPECT_NEAR(first_contact_s(), kGap_mm / 1008, 2e-8);
}

// The TCP accelerates with 490 mm/s2 after a plate that moves away at 100: 490/2 t^2 = 20 + 100 t.
TEST_F(ConveyorContact, AcceleratingRobotCatchesPlate) {
    belt(0, -500, 100);
    const rrs::JointPos from = joints(kGap_mm - 500 - 20, 500, 0);
    monitor.on_segment(line(0, from, from + joints(900, 0, 0), {508, 490}), false);
    EXPECT_NEAR(first_contact_s(), (100 + std::sqrt(100 * 100 + 4 * 245 * 20)) / (2 * 245), 1e-7);
}

TEST_F(ConveyorContact, RobotAtConveyorSpeedKeepsClearance) {
    belt(0, -500, 100);
    const rrs::JointPos from = joints(kGap_mm - 500 - 1, 500, 0);
    monitor.on_segment(line(0, from, from + joints(300, 0, 0), {100}), false);
    EXPECT_TRUE(monitor.contacts().empty());
    ASSERT_TRUE(monitor.nearest());
    EXPECT_NEAR(monitor.nearest()->distance_mm, 1, 1e-4);
}

TEST_F(ConveyorContact, FollowsSpeedChangeWithinSegment) {
    belt(0, 0, -50);
    belt(3, -150, 0);
    belt(5, -150, -200);
    monitor.on_segment(standstill(0, joints(500, 500, 0), 4), false);
    EXPECT_EQ(first_contact_s(), -1);
    monitor.on_segment(standstill(4, joints(500, 500, 0), 16), false);
    EXPECT_NEAR(first_contact_s(), 5 + (kGap_mm - 500 - 150) / 200, 1e-7);
}

TEST_F(ConveyorContact, JumpHasNoContactBetweenItsEnds) {
    belt(0, 0, 0);
    belt(2, -700, 0);  // past the TCP, which it does not touch
    monitor.on_segment(standstill(0, joints(500, 500, 0), 4), false);
    EXPECT_EQ(first_contact_s(), -1);
    belt(5, -500, 0);
    monitor.on_segment(standstill(4, joints(500, 500, 0), 4), false);
    EXPECT_NEAR(first_contact_s(), 5, 1e-9);
    EXPECT_TRUE(monitor.contacts()[0].penetrating);
}

// A bar that turns about its end by a quarter while it moves 100 mm meets the ball at the time given by
// sin(angle).
TEST(MovableFrames, TurnWhileMoving) {
    Cell cell = read_cell(R"(
[cell]
name = "door"
[[object]]
name = "door"
shape = { box_mm = [100.0, 2.0, 100.0] }
frame = { x_mm = 500.0, y_mm = 500.0 }
[[object]]
name = "knob"
attached_to = "door"
shape = { sphere_mm = 2.0 }
frame = { x_mm = 40.0 }
[[shape]]
name = "tip"
on = "tool"
shape = { sphere_mm = 10.0 }
)",
                          "door.toml", af5())
                    .value();
    const std::size_t door = *cell.frames.find("door");
    cell.make_movable(door, false);
    EXPECT_EQ(cell.frames.link(*cell.frames.find("knob")), cell.frames.link(door));
    ClearanceMonitor monitor(cell, af5());
    CartPos open = at(500, 500);
    open.linear() = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()).toRotationMatrix();
    open.translation().z() = 20;
    cell.moving_frames[0].trajectory.add(uniform_motion_between(at(500, 500), open, 10, 12));
    cell.moving_frames[0].trajectory.add({.from_s = 12, .pose = open});
    monitor.on_segment(standstill(0, joints(530, 530, 0), 20), false);
    ASSERT_EQ(monitor.contacts().size(), 1U);
    // Distance of (30, 30) from a line through the origin at the angle a: 30 cos a - 30 sin a = 5 + 1.
    const double angle = M_PI / 4 - std::asin(6 / (30 * std::sqrt(2)));
    EXPECT_NEAR(monitor.contacts()[0].t_s, 10 + 2 * angle / (M_PI / 2), 1e-6);
}

// An object on a frame may have been released to move independently before that frame.
TEST(MovableFrames, MoveRelativeToEachOther) {
    Cell cell = read_cell(R"(
[cell]
name = "lorry"
[[frame]]
name = "lorry"
frame = { x_mm = 100.0 }
[[object]]
name = "box"
attached_to = "lorry"
shape = { sphere_mm = 10.0 }
frame = { y_mm = 300.0 }
[[shape]]
name = "tip"
on = "tool"
shape = { sphere_mm = 10.0 }
)",
                          "lorry.toml", af5())
                    .value();
    const std::size_t lorry = *cell.frames.find("lorry");
    const std::size_t box = *cell.frames.find("box");
    cell.make_movable(box, false);
    cell.make_movable(lorry, false);
    ASSERT_EQ(cell.moving_frames[0].frame, lorry);
    EXPECT_EQ(cell.frames.link(box), cell.frames.link(lorry) + 1);
    ClearanceMonitor monitor(cell, af5());
    cell.moving_frames[0].trajectory.add(uniform_motion_between(at(100), at(500), 0, 10));
    cell.moving_frames[1].trajectory.add(uniform_motion_between(at(0, 300), at(0, 700), 0, 10));
    monitor.on_segment(standstill(0, joints(300, 500, 0), 10), false);
    ASSERT_EQ(monitor.contacts().size(), 1U);
    EXPECT_NEAR(monitor.contacts()[0].t_s, 5 - 10 / (40 * std::sqrt(2)), 1e-7);
}

TEST(CellFile, RejectsConveyorNamedAsMachineFrame) {
    const std::vector<std::string> names{"tool"};
    EXPECT_FALSE(read_cell("[cell]\nname = \"c\"\n", "c.toml", af5(), names));
}

}  // namespace
}  // namespace gsim::cell::carrier_test
