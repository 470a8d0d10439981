// Poses that two rotary axes cannot reach in full: the tool axis counts.

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/kinematics/gantry.h"
#include "motion/kinematics/pose.h"
#include "tests/motion/kinematics/chains.h"

namespace gsim::kinematics::gantry_orientation_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

std::shared_ptr<const GantryKinematics> gantry() {
    return GantryKinematics::make(standard_gantry()).value();
}

// Returns a pose of joints (0, 0, 0, b, c) with the tool also turned about its own axis.
rrs::CartPos spun(double b, double c, double spin) {
    rrs::CartPos pose = gantry()->forward(joint_pos({0, 0, 0, b, c}));
    pose.rotate(AngleAxisd(spin, Vector3d::UnitZ()));
    return pose;
}

TEST(GantryOrientation, MatchesToolAxisIfFullRotationIsUnreachable) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> number(-3, 3);
    for (int i = 0; i < 20'000; ++i) {
        const double b = number(random), c = number(random), spin = number(random);
        const rrs::CartPos pose = spun(b, c, spin);
        const rrs::JointPos near = joint_pos({0, 0, 0, number(random), number(random)});
        const auto q = gantry()->inverse(pose, near);
        ASSERT_TRUE(q) << q.error();
        ASSERT_LT((gantry()->forward(*q).linear().col(2) - pose.linear().col(2)).norm(), 1e-6)
            << b << ' ' << c << ' ' << spin;
    }
}

TEST(GantryOrientation, ReturnsNearestOfTwoSolutions) {
    // (b, c) and (b + pi, -c) point the tool in the same direction.
    const auto first = gantry()->inverse(spun(0.5, 0.3, 1), joint_pos({0, 0, 0, 0.6, 0.2})).value();
    EXPECT_NEAR(first[3], 0.5, 1e-9);
    EXPECT_NEAR(first[4], 0.3, 1e-9);
    const auto second = gantry()->inverse(spun(0.5, 0.3, 1), joint_pos({0, 0, 0, 3.5, -0.2})).value();
    EXPECT_NEAR(second[3], 0.5 + kPi, 1e-9);
    EXPECT_NEAR(second[4], -0.3, 1e-9);
}

TEST(GantryOrientation, FullTurnsFollowNearPosition) {
    const rrs::CartPos pose = gantry()->forward(joint_pos({0, 0, 0, 0.5, 0.3}));
    const auto q = gantry()->inverse(pose, joint_pos({0, 0, 0, 4 * kPi, 0})).value();
    EXPECT_NEAR(q[3], 0.5 + 4 * kPi, 1e-9);
    EXPECT_NEAR(q[4], 0.3, 1e-9);
}

TEST(GantryOrientation, UprightToolTakesFirstAxisFromPose) {
    const auto q =
        gantry()->inverse(gantry()->forward(joint_pos({0, 0, 0, 0.7, 0})), joint_pos({0, 0, 0, 2, 0.1}));
    EXPECT_NEAR((*q)[3], 0.7, 1e-12);
    EXPECT_NEAR((*q)[4], 0, 1e-12);
}

TEST(GantryOrientation, SmallTiltsLoseNoAccuracy) {
    for (const double c : {1e-3, 1e-6, 1e-8, 1e-12}) {
        const rrs::JointPos q = joint_pos({0, 0, 0, 1.2, c});
        const auto back = gantry()->inverse(gantry()->forward(q), joint_pos({0, 0, 0, 0, 0})).value();
        EXPECT_NEAR(back[3], 1.2, 1e-12) << c;
        EXPECT_NEAR(back[4], c, 1e-12);
    }
}

// With the second axis at 45 degrees and the tool along the first, the upside-down direction is beyond reach.
TEST(GantryOrientation, ReportsUnreachableToolAxis) {
    std::vector<DhLink> rows = gantry_rows();
    rows[3].alpha_rad = kPi / 6;
    rows[4].alpha_rad = -kPi / 6;
    const auto head = GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity())).value();
    const rrs::CartPos down = pose_from_rpy({.yaw_rad = kPi});
    EXPECT_THAT(head->inverse(down, joint_pos({0, 0, 0, 0, 0})).error(),
                testing::HasSubstr("2 rotary axes cannot bring the tool into direction"));
}

// If the tool is along the second axis, that axis is the turn about the tool: the machine has no free choice.
TEST(GantryOrientation, ToolAlongSecondAxisTurnsAsPoseRequires) {
    std::vector<DhLink> rows = gantry_rows();
    rows[4].alpha_rad = 0;
    const auto head = GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity())).value();
    const rrs::CartPos pose = head->forward(joint_pos({0, 0, 0, 0.4, 0.2}));
    const rrs::JointPos q = head->inverse(pose, joint_pos({0, 0, 0, 0, 1})).value();
    EXPECT_NEAR(q[3], 0.4, 1e-12);
    EXPECT_NEAR(q[4], 0.2, 1e-12);
    EXPECT_FALSE(head->inverse(pose_from_rpy({.yaw_rad = 0.1}), q));
}

// The pole is the tool's direction with the tilt undone, wherever the head is turned.
TEST(GantryOrientation, HeadTiltsToolFromPole) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    for (int i = 0; i < 100; ++i) {
        auto rows = gantry_rows();
        rows[4].theta_rad = number(random);  // angle at which the tilt is 0
        auto base = gantry_base();
        base.rotate(AngleAxisd(number(random), Vector3d::UnitX()));
        const auto gantry = GantryKinematics::make(DhChain(base, rows, rrs::CartPos::Identity())).value();
        const auto head = gantry->tilting_head();
        ASSERT_TRUE(head);
        EXPECT_EQ(head->turn_joint, 3);
        EXPECT_EQ(head->tilt_joint, 4);
        const auto direction = [&](double turn, double tilt) -> Vector3d {
            return gantry->forward(joint_pos({0, 0, 0, turn, tilt})).linear().col(2);
        };
        const Vector3d pole = direction(number(random), -head->tilt_at_zero_rad);
        const double turn = number(random);
        const double tilt = number(random);
        EXPECT_NEAR(direction(turn, tilt).dot(pole), std::cos(tilt + head->tilt_at_zero_rad), 1e-12);
        const double turned = number(random);
        EXPECT_LT((direction(turn + turned, tilt) - AngleAxisd(turned, pole) * direction(turn, tilt)).norm(),
                  1e-12);
    }
}

TEST(GantryOrientation, TiltingHeadNeedsRightAngles) {
    auto rows = gantry_rows();
    EXPECT_TRUE(GantryKinematics::make(standard_gantry()).value()->tilting_head());
    rows[3].alpha_rad = -kQuarter + 0.1;
    EXPECT_FALSE(GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity()))
                     .value()
                     ->tilting_head());
    rows = gantry_rows();
    rows[4].alpha_rad = kQuarter - 0.1;
    EXPECT_FALSE(GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity()))
                     .value()
                     ->tilting_head());
    rows.pop_back();
    EXPECT_FALSE(GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity()))
                     .value()
                     ->tilting_head());
}

TEST(GantryOrientation, AcceptsOnlyUprightToolWithoutRotaryAxes) {
    const auto rows = std::vector{slide(0, kQuarter), slide(kQuarter, kQuarter), slide(0, 0)};
    const auto three = GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity())).value();
    EXPECT_TRUE(three->inverse(pose_from_rpy({.x_mm = 5, .roll_rad = 1}), joint_pos({0, 0, 0})));
    EXPECT_FALSE(three->inverse(pose_from_rpy({.yaw_rad = 0.1}), joint_pos({0, 0, 0})));
}

}  // namespace
}  // namespace gsim::kinematics::gantry_orientation_test
