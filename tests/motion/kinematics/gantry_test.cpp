#include "motion/kinematics/gantry.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/kinematics/pose.h"
#include "tests/motion/kinematics/chains.h"

namespace gsim::kinematics::gantry_test {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

std::shared_ptr<const GantryKinematics> make(const std::vector<DhLink>& rows,
                                             const rrs::CartPos& base = gantry_base()) {
    return GantryKinematics::make(DhChain(base, rows, rrs::CartPos::Identity())).value();
}

rrs::JointPos random_joints(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> number(-1, 1);
    rrs::JointPos q(count);
    for (int joint = 0; joint < count; ++joint) q[joint] = (joint < 3 ? 2500 : 8) * number(random);
    return q;
}

void expect_round_trips(const GantryKinematics& gantry, unsigned seed) {
    std::mt19937 random(seed);
    for (int i = 0; i < 100'000; ++i) {
        const rrs::JointPos q = random_joints(random, gantry.joint_count());
        const rrs::CartPos pose = gantry.forward(q);
        const auto same = gantry.inverse(pose, q);
        ASSERT_TRUE(same) << same.error() << " q " << q.transpose();
        ASSERT_LT((*same - q).cwiseAbs().maxCoeff(), 1e-9) << "q " << q.transpose();

        const rrs::JointPos near = random_joints(random, gantry.joint_count());
        const auto other = gantry.inverse(pose, near);
        ASSERT_TRUE(other) << other.error() << " q " << q.transpose();
        ASSERT_LT((gantry.forward(*other).matrix() - pose.matrix()).cwiseAbs().maxCoeff(), 1e-9)
            << "q " << q.transpose() << " near " << near.transpose();
        for (int joint = 3; joint < gantry.joint_count(); ++joint) {
            ASSERT_LE(std::abs((*other)[joint] - near[joint]), kPi + 1e-9) << "q " << q.transpose();
        }
    }
}

TEST(Gantry, InverseInvertsForward) {
    expect_round_trips(*make(gantry_rows()), 1);
}

TEST(Gantry, InverseWorksWithOtherOrdersOfLinearAxes) {
    // Any base, and slides along its Z, then -Y, then X.
    const rrs::CartPos base =
        pose_from_rpy({.x_mm = 100, .y_mm = -7, .roll_rad = 0.3, .pitch_rad = -1.1, .yaw_rad = 2});
    const auto rows = std::vector{slide(0, kQuarter), slide(kQuarter, kQuarter), slide(kQuarter, 0.4),
                                  turn(0.2, kQuarter), turn(1, 0.1)};
    expect_round_trips(*make(rows, base), 2);
}

TEST(Gantry, InverseWorksWithNutatingHead) {
    // A nutating head: the second axis at 45 degrees to the first.
    expect_round_trips(
        *make({slide(0, kQuarter), slide(kQuarter, kQuarter), slide(0, 0), turn(0, kPi / 4), turn(0, 0.3)}),
        3);
}

TEST(Gantry, InverseWorksWithOneRotaryAxisOrNone) {
    expect_round_trips(*make({slide(0, kQuarter), slide(kQuarter, kQuarter), slide(0, 0), turn(0, 0.7)}), 4);
    expect_round_trips(*make({slide(0, kQuarter), slide(kQuarter, kQuarter), slide(0, 0)}), 5);
}

TEST(Gantry, TcpStaysWhileRotaryAxesTurn) {
    const auto gantry = make(gantry_rows());
    const Eigen::Vector3d a = gantry->forward(joint_pos({100, 200, 300, 0, 0})).translation();
    const Eigen::Vector3d b = gantry->forward(joint_pos({100, 200, 300, 2, -1})).translation();
    EXPECT_LT((a - b).norm(), 1e-9);
}

TEST(Gantry, RejectsUnsupportedKinematics) {
    const auto error_text = [](std::vector<DhLink> rows) {
        return GantryKinematics::make(DhChain(gantry_base(), rows, rrs::CartPos::Identity())).error();
    };
    auto rows = gantry_rows();
    rows[3].alpha_rad = 0;
    EXPECT_EQ(error_text(rows),
              "The gantry's closed-form inverse needs two rotary axes that are not parallel.");
    rows = gantry_rows();
    rows[0].alpha_rad = 0;
    EXPECT_EQ(error_text(rows),
              "The gantry's closed-form inverse needs three linear axes that do not lie in one plane.");
    rows = gantry_rows();
    rows.push_back(slide(0, 0));
    EXPECT_EQ(error_text(rows),
              "The gantry's closed-form inverse is for three linear axes and at most two rotary ones; this "
              "chain has 4 linear and 2 rotary joints.");
    rows = gantry_rows();
    rows[1].d_mm = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(error_text(rows), HasSubstr("not finite"));
}

TEST(Gantry, RejectsInvalidPoseAndNearPosition) {
    const auto gantry = make(gantry_rows());
    rrs::CartPos pose = rrs::CartPos::Identity();
    EXPECT_FALSE(gantry->inverse(pose, joint_pos({0, 0, 0})));
    EXPECT_FALSE(gantry->inverse(pose, joint_pos({0, 0, 0, 0, std::numeric_limits<double>::infinity()})));
    pose.linear() *= 2;
    EXPECT_THAT(gantry->inverse(pose, joint_pos({0, 0, 0, 0, 0})).error(), HasSubstr("not a rotation"));
}

}  // namespace
}  // namespace gsim::kinematics::gantry_test
