#include "motion/kinematics/dh_chain.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/motion/kinematics/chains.h"

namespace gsim::kinematics::dh_chain_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix4d;
using Eigen::Vector3d;

// The textbook form of one row, written out element by element.
Matrix4d textbook(const DhLink& row, double value) {
    const bool revolute = row.kind == rrs::JointKind::revolute;
    const double theta = row.theta_rad + (revolute ? value : 0);
    const double d = row.d_mm + (revolute ? 0 : value);
    const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(row.alpha_rad),
                 sa = std::sin(row.alpha_rad);
    Matrix4d m;
    m << ct, -st * ca, st * sa, row.a_mm * ct,  //
        st, ct * ca, -ct * sa, row.a_mm * st,   //
        0, sa, ca, d,                           //
        0, 0, 0, 1;
    return m;
}

TEST(DhChain, ForwardIsProductOfTextbookMatrices) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-3, 3);
    for (int i = 0; i < 10'000; ++i) {
        std::vector<DhLink> rows;
        Matrix4d expected = Matrix4d::Identity();
        rrs::JointPos joints(6);
        for (int joint = 0; joint < 6; ++joint) {
            const auto kind = number(random) > 0 ? rrs::JointKind::revolute : rrs::JointKind::prismatic;
            rows.push_back(
                {kind, number(random), 100 * number(random), 100 * number(random), number(random)});
            joints[joint] = number(random);
            expected = expected * textbook(rows.back(), joints[joint]);
        }
        const DhChain chain(rrs::CartPos::Identity(), rows, rrs::CartPos::Identity());
        ASSERT_TRUE(chain.forward(joints).matrix().isApprox(expected, 1e-12)) << "case " << i;
    }
}

TEST(DhChain, StandardGantryTranslatesThenTurnsRzBThenRyC) {
    const DhChain chain = standard_gantry();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(-3, 3);
    for (int i = 0; i < 10'000; ++i) {
        const rrs::JointPos q = joint_pos({1000 * number(random), 1000 * number(random),
                                           1000 * number(random), 2 * number(random), number(random)});
        const rrs::CartPos pose = chain.forward(q);
        ASSERT_TRUE(pose.translation().isApprox(q.head<3>(), 1e-12)) << q.transpose();
        const Eigen::Matrix3d turned =
            (AngleAxisd(q[3], Vector3d::UnitZ()) * AngleAxisd(q[4], Vector3d::UnitY())).toRotationMatrix();
        ASSERT_TRUE(pose.linear().isApprox(turned, 1e-12)) << q.transpose();
    }
}

TEST(DhChain, GantryCoordinatesHaveNoRounding) {
    const rrs::CartPos pose = standard_gantry().forward(joint_pos({1234.5, 77.25, 300.125, 0, 0}));
    EXPECT_EQ(pose.matrix(), (rrs::CartPos(Eigen::Translation3d(1234.5, 77.25, 300.125)).matrix()));
}

TEST(DhChain, FramesBeginWithBaseAndEndWithTool) {
    rrs::CartPos tool = rrs::CartPos::Identity();
    tool.translation().z() = -150;
    const DhChain chain(gantry_base(), gantry_rows(), tool);
    const rrs::JointPos q = joint_pos({10, 20, 30, 0.4, 0.5});
    const auto frames = chain.tool_frames(q);
    ASSERT_EQ(frames.size(), 7U);
    EXPECT_TRUE(frames.front().isApprox(gantry_base()));
    EXPECT_TRUE(frames[1].translation().isApprox(Vector3d(10, 0, 0)));
    EXPECT_TRUE(frames[3].translation().isApprox(Vector3d(10, 20, 30)));
    EXPECT_TRUE(frames.back().isApprox(chain.forward(q)));
    EXPECT_TRUE(frames.back().isApprox(frames[5] * tool));
}

TEST(DhChain, IsToolOnBaseWithoutJoints) {
    const DhChain chain(gantry_base(), {}, gantry_base());
    EXPECT_TRUE(chain.forward(rrs::JointPos()).isApprox(gantry_base() * gantry_base()));
}

TEST(DhChain, RejectsTooManyJoints) {
    const std::vector<DhLink> rows(17);
    EXPECT_THROW(DhChain(gantry_base(), rows, gantry_base()), std::invalid_argument);
}

TEST(ChainKinematics, HasForwardButNoInverse) {
    const ChainKinematics chain(standard_gantry());
    const rrs::JointPos q = joint_pos({1, 2, 3, 0.4, 0.5});
    EXPECT_EQ(chain.joint_count(), 5);
    EXPECT_TRUE(chain.forward(q).isApprox(standard_gantry().forward(q)));
    EXPECT_EQ(chain.inverse(chain.forward(q), q).error(),
              "This machine has no inverse kinematics; give the target as joint values.");
}

}  // namespace
}  // namespace gsim::kinematics::dh_chain_test
