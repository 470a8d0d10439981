// The closed inverse of machines with rotary axes on the tool's side, the work's side, or both.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/kinematics/gantry.h"
#include "tests/motion/kinematics/chains.h"
#include "tests/motion/kinematics/random_pose.h"

namespace gsim::kinematics::five_axis_test {
namespace {

using Eigen::Vector3d;
using rrs::JointKind;

// Returns a joint with `direction` in the world as its Z. The frames of joints before and after it are the
// world's.
Link joint_along(int joint, JointKind kind, const Vector3d& direction, const Vector3d& position) {
    Link link{.joint = joint, .kind = kind};
    link.before.linear() =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), direction).toRotationMatrix();
    link.before.translation() = position;
    link.after.linear() = link.before.linear().transpose();
    return link;
}

// Slides and rotary axes dealt out at random; directions off the main ones, rotary axes anywhere.
Chain random_machine(RandomPoses& random, int rotary) {
    Branch tool{.base = random.pose(500), .links = {}, .end = random.pose(200)};
    Branch work{.base = random.pose(500), .links = {}, .end = random.pose(200)};
    std::vector<Vector3d> slides{Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
    std::vector<std::pair<JointKind, Vector3d>> joints;
    for (const Vector3d& slide : slides) joints.emplace_back(JointKind::prismatic, slide);
    for (int i = 0; i < rotary; ++i) {
        const Vector3d axis = i == 0 ? Vector3d::UnitZ() : Vector3d::UnitX();
        joints.emplace_back(
            JointKind::revolute,
            (axis + 0.4 * Vector3d(random.number(-1, 1), random.number(-1, 1), 0)).normalized());
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        // A slide after rotary axes moves with them; the slides stay near the world, so that they span space.
        Branch& side = random.number(0, 1) < 0.5 ? tool : work;
        const Vector3d position(random.number(-100, 100), random.number(-100, 100), random.number(-100, 100));
        side.links.push_back(joint_along(static_cast<int>(i), joints[i].first, joints[i].second, position));
    }
    tool.base.linear().setIdentity();
    work.base.linear().setIdentity();
    return Chain(tool, work);
}

TEST(FiveAxis, InverseInvertsForwardOnRandomMachines) {
    RandomPoses random(11);
    for (int machine = 0; machine < 200; ++machine) {
        const auto gantry = GantryKinematics::make(random_machine(random, machine % 3));
        ASSERT_TRUE(gantry) << gantry.error();
        for (int i = 0; i < 200; ++i) {
            const rrs::JointPos q = random.joints((*gantry)->chain());
            const rrs::CartPos pose = (*gantry)->forward(q);
            const auto back = (*gantry)->inverse(pose, q);
            ASSERT_TRUE(back) << back.error();
            ASSERT_LT((*back - q).cwiseAbs().maxCoeff(), 1e-9) << machine << ": " << q.transpose();
            const auto other = (*gantry)->inverse(pose, random.joints((*gantry)->chain()));
            ASSERT_TRUE(other) << other.error();
            ASSERT_LT(pose_distance((*gantry)->forward(*other), pose), 1e-9)
                << machine << ": " << q.transpose();
        }
    }
}

// Every solution has the TCP and the tool's axis right; two rotary axes can tilt in two directions.
TEST(FiveAxis, AllSolutionsGiveSameToolDirection) {
    RandomPoses random(12);
    for (int machine = 0; machine < 100; ++machine) {
        const auto gantry = GantryKinematics::make(random_machine(random, 2)).value();
        for (int i = 0; i < 50; ++i) {
            const rrs::JointPos q = random.joints(gantry->chain());
            rrs::CartPos pose = gantry->forward(q);
            const auto exact = gantry->solutions(pose, q).value();
            ASSERT_EQ(exact.size(), 2U);
            ASSERT_LT(pose_distance(gantry->forward(exact[0]), pose), 1e-9);
            pose.rotate(Eigen::AngleAxisd(random.number(0.1, 3), Vector3d::UnitZ()));
            const auto spun = gantry->solutions(pose, q).value();
            ASSERT_EQ(spun.size(), 2U);
            ASSERT_LT((spun[0] - q).norm(), (spun[1] - q).norm() + 1e-9);
            for (const rrs::JointPos& joints : spun) {
                const rrs::CartPos reached = gantry->forward(joints);
                ASSERT_LT((reached.translation() - pose.translation()).norm(), 1e-9);
                ASSERT_LT((reached.linear().col(2) - pose.linear().col(2)).norm(), 1e-6);
            }
        }
    }
}

TEST(FiveAxis, PrefersSolutionInRangeToNearerOne) {
    std::vector<JointRange> ranges(5);
    ranges[4] = {.min = -0.1, .max = 2};  // tilts to one side
    const auto gantry = GantryKinematics::make(standard_gantry(), ranges).value();
    rrs::CartPos pose = gantry->forward(joint_pos({1, 2, 3, 0.5, -0.3}));
    pose.rotate(Eigen::AngleAxisd(1, Vector3d::UnitZ()));
    const auto all = gantry->solutions(pose, joint_pos({0, 0, 0, 0.5, -0.1})).value();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_NEAR(all[0][4], 0.3, 1e-9);
    EXPECT_NEAR(all[1][4], -0.3, 1e-9);
}

TEST(FiveAxis, FullTurnsStayInRange) {
    std::vector<JointRange> ranges(5);
    ranges[3] = {.min = -1, .max = 6};
    const auto gantry = GantryKinematics::make(standard_gantry(), ranges).value();
    const auto at = [&](double b, double near) {
        return gantry->inverse(gantry->forward(joint_pos({0, 0, 0, b, 0.3})), joint_pos({0, 0, 0, near, 0.3}))
            .value()[3];
    };
    EXPECT_NEAR(at(5, -1), 5, 1e-12);  // and not -1.28
    EXPECT_NEAR(at(5.2, -1), 5.2, 1e-12);
    EXPECT_NEAR(at(5.5, -0.5), -0.783185307179586, 1e-12);
    EXPECT_NEAR(at(0, 6), 0, 1e-12);
}

// Z after the tilting axis lies along Y if that axis has turned by 90 degrees.
TEST(FiveAxis, ReportsSingularityIfLinearAxesAreCoplanar) {
    Branch tool;
    tool.links = {joint_along(0, JointKind::prismatic, Vector3d::UnitX(), Vector3d::Zero()),
                  joint_along(1, JointKind::prismatic, Vector3d::UnitY(), Vector3d::Zero()),
                  joint_along(2, JointKind::revolute, Vector3d::UnitX(), Vector3d::Zero()),
                  joint_along(3, JointKind::prismatic, Vector3d::UnitZ(), Vector3d::Zero())};
    const auto quill = GantryKinematics::make(Chain(tool)).value();
    EXPECT_TRUE(quill->inverse(pose_from_rpy({.yaw_rad = 1.5}), joint_pos({0, 0, 0, 0})));
    EXPECT_EQ(quill->inverse(pose_from_rpy({.yaw_rad = kQuarter}), joint_pos({0, 0, 0, 0})).error(),
              "The pose is singular: at the required values of the rotary axes, the linear axes move in one "
              "plane.");
}

// A head that turns the tool about its TCP is defined by its TCP, not by its directions alone.
TEST(FiveAxis, HasNoTiltingHeadIfTcpIsOffRotationPoint) {
    const auto with_tool = [](double z_mm) {
        return GantryKinematics::make(DhChain(gantry_base(), gantry_rows(), pose_from_rpy({.z_mm = z_mm})))
            .value()
            ->tilting_head();
    };
    EXPECT_TRUE(with_tool(0));
    EXPECT_FALSE(with_tool(-100));
}

TEST(FiveAxis, ReportsAngularErrorOfUnreachablePose) {
    auto rows = gantry_rows();
    rows.pop_back();  // upright, about the vertical alone
    const auto gantry =
        GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity())).value();
    const rrs::CartPos pose = gantry->forward(joint_pos({0, 0, 0, 0})) * pose_from_rpy({.yaw_rad = 0.1});
    EXPECT_THAT(gantry->inverse(pose, joint_pos({0, 0, 0, 0})).error(),
                testing::EndsWith("they miss it by 5.72958 deg."));
}

}  // namespace
}  // namespace gsim::kinematics::five_axis_test
