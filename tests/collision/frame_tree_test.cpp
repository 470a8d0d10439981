#include "collision/cell/frame_tree.h"

#include <gtest/gtest.h>

#include "tests/collision/meshes.h"
#include "tests/collision/segments.h"

namespace gsim::cell::frame_tree_test {
namespace {

TEST(FrameTree, FramesMoveWithParent) {
    const machine::Machine machine = af5();
    FrameTree frames(machine);
    const auto table = frames.add("table", *frames.find("world"), shift(100, 0, 0));
    const auto part = frames.add("part", table, shift(10, 20, 0));
    const auto camera = frames.add("camera", *frames.find("Z"), shift(1, 2, 3));
    const auto kinematics = machine::make_kinematics(machine);
    const LinkFrames links = link_frames(*kinematics, joints(10, 20, 30, 0.5, 0.25));
    EXPECT_TRUE(frames.pose_in_world(part, links).isApprox(shift(110, 20, 0)));
    frames.move(table, shift(200, 0, 5));
    EXPECT_TRUE(frames.pose_in_world(part, links).isApprox(shift(210, 20, 5)));
    EXPECT_EQ(frames.link(part), 0);
    EXPECT_EQ(frames.link(camera), 3);
    EXPECT_TRUE(frames.pose_in_world(camera, links).isApprox(links[3] * shift(1, 2, 3)));
}

TEST(FrameTree, ToolFrameMatchesKinematics) {
    machine::Machine machine = af5();
    machine.base.z_mm = 100;
    const auto kinematics = machine::make_kinematics(machine);
    const FrameTree frames(machine);
    const rrs::JointPos at = joints(10, 20, 30, 0.5, 0.25);
    const LinkFrames links = link_frames(*kinematics, at);
    EXPECT_TRUE(frames.pose_in_world(*frames.find("tool"), links).isApprox(kinematics->forward(at)));
    EXPECT_TRUE(frames.is_machine_frame(*frames.find("tool")));
    EXPECT_FALSE(frames.find("Q"));
}

TEST(FrameTree, WorkAxesMoveWorkFrame) {
    machine::Machine machine = af5();
    machine.axes[0].carries = machine::CarriedPart::work;
    machine.inverse = machine::InverseKind::none;
    const auto kinematics = machine::make_kinematics(machine);
    const FrameTree frames(machine);
    const rrs::JointPos at = joints(10, 20, 30, 0.5, 0.25);
    const LinkFrames links = link_frames(*kinematics, at);
    const rrs::CartPos work = frames.pose_in_world(*frames.find("work"), links);
    const rrs::CartPos tool = frames.pose_in_world(*frames.find("tool"), links);
    EXPECT_TRUE((work.inverse() * tool).isApprox(kinematics->forward(at), 1e-9));
    EXPECT_EQ(frames.link(*frames.find("work")), 1);
    EXPECT_EQ(joints_between(*kinematics, 5, 1), (std::vector<int>{4, 3, 2, 1, 0}));
    EXPECT_EQ(joints_between(*kinematics, 1, 2), (std::vector<int>{0, 1}));
    EXPECT_EQ(joints_between(*kinematics, 5, 3), (std::vector<int>{4, 3}));
    EXPECT_TRUE(joints_between(*kinematics, 0, 0).empty());
}

}  // namespace
}  // namespace gsim::cell::frame_tree_test
