#include "motion/kinematics/chain.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "motion/kinematics/dh_chain.h"
#include "motion/kinematics/jacobian.h"
#include "motion/kinematics/screws.h"
#include "tests/motion/kinematics/random_pose.h"

namespace gsim::kinematics::chain_test {
namespace {

using Eigen::Vector3d;
using rrs::JointKind;

rrs::CartPos moved(JointKind kind, double value) {
    rrs::CartPos motion = rrs::CartPos::Identity();
    if (kind == JointKind::prismatic) motion.translate(Vector3d(0, 0, value));
    if (kind == JointKind::revolute) motion.rotate(Eigen::AngleAxisd(value, Vector3d::UnitZ()));
    return motion;
}

JointKind random_kind(RandomPoses& random) {
    return random.number(0, 1) < 0.5 ? JointKind::prismatic : JointKind::revolute;
}

// Six joints dealt out to both sides, numbered backwards.
Chain random_chain(RandomPoses& random) {
    Branch tool{.base = random.pose(500), .links = {}, .end = random.pose(100)};
    Branch work{.base = random.pose(500), .links = {}, .end = random.pose(100)};
    for (int joint = 5; joint >= 0; --joint)
        (random.number(0, 1) < 0.5 ? tool : work).links.push_back(random.link(joint, random_kind(random)));
    return Chain(tool, work);
}

rrs::CartPos product(const Branch& branch, const rrs::JointPos& joints) {
    rrs::CartPos pose = branch.base;
    for (const Link& link : branch.links)
        pose = pose * link.before * moved(link.kind, joints[link.joint]) * link.after;
    return pose * branch.end;
}

TEST(Chain, ForwardIsToolPoseRelativeToWork) {
    RandomPoses random(1);
    for (int i = 0; i < 2'000; ++i) {
        const Chain chain = random_chain(random);
        const rrs::JointPos q = random.joints(chain);
        const rrs::CartPos tool = product(chain.tool_side(), q);
        const rrs::CartPos work = product(chain.work_side(), q);
        ASSERT_LT(pose_distance(chain.forward(q), work.inverse() * tool), 1e-9) << q.transpose();
        ASSERT_LT(pose_distance(chain.tool_frames(q).back(), tool), 1e-9);
        ASSERT_LT(pose_distance(chain.work_frames(q).back(), work), 1e-9);
        ASSERT_EQ(chain.tool_frames(q).size() + chain.work_frames(q).size(), 10U);
    }
}

TEST(Chain, JointMovesToolOrWorkAlongOrAboutItsZ) {
    RandomPoses random(2);
    for (int i = 0; i < 500; ++i) {
        const Chain chain = random_chain(random);
        const rrs::JointPos q = random.joints(chain);
        const auto frames = chain.joint_frames(q);
        for (int joint = 0; joint < 6; ++joint) {
            rrs::JointPos further = q;
            further[joint] += 0.5;
            const rrs::CartPos& frame = frames[static_cast<std::size_t>(joint)];
            const rrs::CartPos step = frame * moved(chain.kind(joint), 0.5) * frame.inverse();
            const rrs::CartPos tool = chain.tool_frames(further).back();
            const rrs::CartPos work = chain.work_frames(further).back();
            const bool carries_tool = pose_distance(tool, step * chain.tool_frames(q).back()) < 1e-9;
            const bool carries_work = pose_distance(work, step * chain.work_frames(q).back()) < 1e-9;
            ASSERT_TRUE(carries_tool != carries_work) << joint;
        }
    }
}

TEST(Chain, EqualsProductOfExponentials) {
    RandomPoses random(3);
    for (int i = 0; i < 2'000; ++i) {
        const Chain chain = random_chain(random);
        const rrs::JointPos q = random.joints(chain);
        const ScrewChain screws = screw_chain(chain);
        rrs::CartPos pose = screws.work_at_zero.inverse();
        for (const Screw& screw : screws.screws) {
            const double value = q[screw.joint];
            if (screw.kind == JointKind::prismatic) {
                pose.translate(value * screw.direction);
            } else {
                pose.translate(screw.point);
                pose.rotate(Eigen::AngleAxisd(value, screw.direction));
                pose.translate(-screw.point);
            }
        }
        ASSERT_LT(pose_distance(pose * screws.tool_at_zero, chain.forward(q)), 1e-8);
    }
}

TEST(Chain, AnyChainConvertsToDenavitHartenbergTable) {
    RandomPoses random(4);
    for (int i = 0; i < 2'000; ++i) {
        const Chain chain = random_chain(random);
        const rrs::JointPos q = random.joints(chain);
        const DhTable table = dh_table(chain);
        rrs::JointPos by_row(6);
        for (std::size_t row = 0; row < 6; ++row)
            by_row[static_cast<Eigen::Index>(row)] = q[table.joints[row]];
        const DhChain converted(table.base, table.rows, table.tool);
        ASSERT_LT(pose_distance(converted.forward(by_row), chain.forward(q)), 1e-7) << i;
    }
}

TEST(Chain, DhTableKeepsParallelAndCollinearAxes) {
    RandomPoses random(5);
    Branch tool;
    // One line, a parallel one, a parallel one against it, and one at right angles.
    for (const auto& before :
         {rrs::CartPos::Identity(), pose_from_rpy({.z_mm = 70}), pose_from_rpy({.x_mm = 30, .y_mm = -4}),
          pose_from_rpy({.x_mm = 5, .yaw_rad = std::acos(-1.0)}), pose_from_rpy({.pitch_rad = 1})}) {
        const int joint = static_cast<int>(tool.links.size());
        const JointKind kind = joint == 2 ? JointKind::prismatic : JointKind::revolute;
        tool.links.push_back({.joint = joint, .kind = kind, .before = before});
    }
    const Chain chain(tool);
    const DhTable table = dh_table(chain);
    const DhChain converted(table.base, table.rows, table.tool);
    for (int i = 0; i < 1'000; ++i) {
        const rrs::JointPos q = random.joints(chain);
        ASSERT_LT(pose_distance(converted.forward(q), chain.forward(q)), 1e-9);
    }
}

TEST(Chain, RejectsDuplicateAndMissingJointNumbers) {
    Branch twice;
    twice.links = {Link{.joint = 0}, Link{.joint = 0}};
    EXPECT_THROW(Chain{twice}, std::invalid_argument);
    Branch gap;
    gap.links = {Link{.joint = 1}};
    EXPECT_THROW(Chain{gap}, std::invalid_argument);
    gap.links = {Link{.joint = -1}};
    EXPECT_THROW(Chain{gap}, std::invalid_argument);
}

// An axis that feeds filament has a value, and moves neither the tool nor the work.
TEST(Chain, IdleJointsMoveNothing) {
    RandomPoses random(7);
    Branch tool{.base = random.pose(500), .end = random.pose(100)};
    tool.links = {random.link(0, JointKind::prismatic), random.link(2, JointKind::revolute)};
    const Chain chain(tool, {}, {1});
    EXPECT_EQ(chain.joint_count(), 3);
    EXPECT_EQ(chain.kind(1), JointKind::prismatic);
    const rrs::JointPos q = random.joints(chain);
    rrs::JointPos further = q;
    further[1] += 50;
    EXPECT_EQ(chain.forward(further).matrix(), chain.forward(q).matrix());
    EXPECT_TRUE(configuration(chain, q).jacobian.col(1).isZero(0));
    EXPECT_TRUE(chain.joint_frames(q)[1].matrix().isIdentity(0));
    EXPECT_EQ(kinematics::moved(chain, random.pose(10)).idle_joints(), std::vector<int>{1});
    EXPECT_THROW(Chain(tool, {}, {2}), std::invalid_argument);
}

// The Jacobian against differences of poses.
TEST(Jacobian, IsDerivativeOfPose) {
    RandomPoses random(6);
    for (int i = 0; i < 300; ++i) {
        const Chain chain = random_chain(random);
        const rrs::JointPos q = random.joints(chain);
        const Configuration current = configuration(chain, q);
        for (int joint = 0; joint < 6; ++joint) {
            constexpr double kStep = 1e-6;
            rrs::JointPos further = q;
            further[joint] += kStep;
            const Twist difference = twist_to_pose(current, chain.forward(further)) / kStep;
            ASSERT_LT((difference - current.jacobian.col(joint)).norm(), 1e-2) << joint;
            ASSERT_LT((difference - current.jacobian.col(joint)).tail<3>().norm(), 1e-5) << joint;
        }
    }
}

}  // namespace
}  // namespace gsim::kinematics::chain_test
