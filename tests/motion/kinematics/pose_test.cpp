#include "motion/kinematics/pose.h"

#include <limits>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::kinematics::pose_test {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

TEST(Pose, RollTurnsAboutZPitchAboutYYawAboutX) {
    EXPECT_TRUE((pose_from_rpy({.roll_rad = kPi / 2}) * Vector3d::UnitX()).isApprox(Vector3d::UnitY()));
    EXPECT_TRUE((pose_from_rpy({.pitch_rad = kPi / 2}) * Vector3d::UnitX()).isApprox(-Vector3d::UnitZ()));
    EXPECT_TRUE((pose_from_rpy({.yaw_rad = kPi / 2}) * Vector3d::UnitY()).isApprox(Vector3d::UnitZ()));
}

TEST(Pose, YawActsFirstAndRollLast) {
    // Y moves to Z by the yaw, to X by the pitch, to Y by the roll.
    const rrs::CartPos pose =
        pose_from_rpy({.x_mm = 1, .roll_rad = kPi / 2, .pitch_rad = kPi / 2, .yaw_rad = kPi / 2});
    EXPECT_TRUE((pose * Vector3d::UnitY()).isApprox(Vector3d(1, 1, 0)));
}

TEST(Pose, AnglesRoundTripOnRandomPoses) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-3.1, 3.1);
    for (int i = 0; i < 100'000; ++i) {
        const Rpy rpy{1, -2, 3, angle(random), angle(random) / 2, angle(random)};
        const Rpy back = rpy_from_pose(pose_from_rpy(rpy));
        ASSERT_NEAR(back.roll_rad, rpy.roll_rad, 1e-9)
            << rpy.roll_rad << ' ' << rpy.pitch_rad << ' ' << rpy.yaw_rad;
        ASSERT_NEAR(back.pitch_rad, rpy.pitch_rad, 1e-9);
        ASSERT_NEAR(back.yaw_rad, rpy.yaw_rad, 1e-9);
        ASSERT_EQ(back.y_mm, -2);
    }
}

TEST(Pose, GimbalLockSetsYawToZero) {
    for (const double pitch : {kPi / 2, -kPi / 2}) {
        const rrs::CartPos pose = pose_from_rpy({.roll_rad = 0.3, .pitch_rad = pitch, .yaw_rad = 0.8});
        const Rpy rpy = rpy_from_pose(pose);
        EXPECT_EQ(rpy.yaw_rad, 0);
        EXPECT_TRUE(pose_from_rpy(rpy).isApprox(pose, 1e-12));
    }
}

TEST(Pose, CheckReportsInvalidPose) {
    rrs::CartPos pose = pose_from_rpy({.roll_rad = 1, .pitch_rad = 2, .yaw_rad = 3});
    EXPECT_TRUE(check_pose(pose));
    pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(check_pose(pose).error(), "The pose contains a value that is not finite.");
    pose = rrs::CartPos::Identity();
    pose.matrix()(3, 3) = 2;
    EXPECT_EQ(check_pose(pose).error(), "The last row of the pose's matrix is not 0 0 0 1.");
    pose = rrs::CartPos::Identity();
    pose.linear().col(0) *= -1;  // a mirror
    EXPECT_THAT(check_pose(pose).error(), testing::HasSubstr("is not a rotation"));
    pose.linear() = Eigen::Matrix3d::Zero();
    EXPECT_FALSE(check_pose(pose));
}

}  // namespace
}  // namespace gsim::kinematics::pose_test
