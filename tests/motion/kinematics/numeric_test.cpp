#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/kinematics/numeric_kinematics.h"
#include "tests/motion/kinematics/chains.h"
#include "tests/motion/kinematics/random_pose.h"

namespace gsim::kinematics::numeric_test {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// An arm with a spherical wrist and shoulder offset, in the proportions of the PUMA 560.
DhChain arm() {
    const auto joint = [](double d, double a, double alpha) {
        return DhLink{.kind = rrs::JointKind::revolute, .d_mm = d, .a_mm = a, .alpha_rad = alpha};
    };
    return DhChain(rrs::CartPos::Identity(),
                   {joint(0, 0, kQuarter), joint(0, 431.8, 0), joint(150.05, 20.3, -kQuarter),
                    joint(431.8, 0, kQuarter), joint(0, 0, -kQuarter), joint(0, 0, 0)},
                   pose_from_rpy({.z_mm = 100}));
}

std::shared_ptr<const NumericKinematics> numeric(std::vector<JointRange> ranges = {}) {
    return NumericKinematics::make(arm(), std::move(ranges)).value();
}

TEST(Numeric, FindsJointsForRandomPoses) {
    RandomPoses random(21);
    const auto robot = numeric();
    for (int i = 0; i < 2'000; ++i) {
        const rrs::JointPos q = random.joints(robot->chain());
        const rrs::CartPos pose = robot->forward(q);
        const auto found = robot->inverse(pose, random.joints(robot->chain()));
        ASSERT_TRUE(found) << found.error() << " q " << q.transpose();
        ASSERT_LT(pose_distance(robot->forward(*found), pose), 1e-6) << q.transpose();
    }
}

// With a spherical wrist and an arm of three links, a pose generally has eight solutions.
TEST(Numeric, FindsAllEightSolutionsOfArm) {
    const auto robot = numeric();
    const rrs::JointPos q = joint_pos({0.3, 0.8, -0.4, 0.6, 0.9, -1});
    const rrs::CartPos pose = robot->forward(q);
    const auto all = robot->solutions(pose, q).value();
    EXPECT_EQ(all.size(), 8U);
    EXPECT_LT((all[0] - q).norm(), 1e-6);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_LT(pose_distance(robot->forward(all[i]), pose), 1e-6);
        EXPECT_LE((all[i] - q).cwiseAbs().maxCoeff(), kPi + 1e-9);
        EXPECT_GE((all[i] - q).norm(), (all[i > 0 ? i - 1 : 0] - q).norm());
    }
}

TEST(Numeric, SolutionsStayInRange) {
    const std::vector<JointRange> ranges(6, {.min = -2, .max = 1.5});
    const auto robot = numeric(ranges);
    RandomPoses random(22);
    for (int i = 0; i < 300; ++i) {
        rrs::JointPos q(6);
        for (double& value : q) value = random.number(-2, 1.5);
        const auto found = robot->inverse(robot->forward(q), rrs::JointPos::Zero(6));
        ASSERT_TRUE(found) << found.error() << " q " << q.transpose();
        ASSERT_GE(found->minCoeff(), -2 - 1e-9);
        ASSERT_LE(found->maxCoeff(), 1.5 + 1e-9);
    }
}

TEST(Numeric, SolvesRandomChains) {
    RandomPoses random(23);
    for (int machine = 0; machine < 30; ++machine) {
        Branch tool{.base = random.pose(300), .links = {}, .end = random.pose(100)};
        Branch work{.base = random.pose(300), .links = {}, .end = random.pose(100)};
        for (int joint = 0; joint < 5 + machine % 4; ++joint) {
            const auto kind = joint % 3 == 0 ? rrs::JointKind::prismatic : rrs::JointKind::revolute;
            (joint % 2 == 0 ? tool : work).links.push_back(random.link(joint, kind));
        }
        const auto robot = NumericKinematics::make(Chain(tool, work)).value();
        for (int i = 0; i < 10; ++i) {
            const rrs::JointPos q = random.joints(robot->chain());
            rrs::JointPos near = q;
            for (double& value : near) value += random.number(-0.2, 0.2);
            const auto found = robot->inverse(robot->forward(q), near);
            ASSERT_TRUE(found) << found.error();
            ASSERT_LT(pose_distance(robot->forward(*found), robot->forward(q)), 1e-6);
        }
    }
}

TEST(Numeric, ReportsNearestPoseIfOutOfReach) {
    const auto robot = numeric();
    // Straight up, beyond the stretched arm: hypot(431.8, ...) + 100 mm of tool.
    const rrs::CartPos far = pose_from_rpy({.x_mm = 3000});
    const std::string error = robot->inverse(far, rrs::JointPos::Zero(6)).error();
    EXPECT_THAT(error, HasSubstr("The pose is out of reach: the nearest pose of the joints is "));
    EXPECT_THAT(error, testing::EndsWith(" aligned."));
    const auto narrow = numeric(std::vector<JointRange>(6, {.min = -0.1, .max = 0.1}));
    EXPECT_THAT(narrow->inverse(pose_from_rpy({.z_mm = 400}), rrs::JointPos::Zero(6)).error(),
                HasSubstr("at a limit of the range"));
}

TEST(Numeric, ReturnsAlignedJoints) {
    const auto robot = numeric();
    EXPECT_EQ(robot->aligned_joints(joint_pos({0.3, 0.8, -0.4, 0.6, 0, -1})), (std::vector{3, 5}));
    EXPECT_EQ(robot->aligned_joints(joint_pos({0.3, 0.8, -0.4, 0.6, 0.5, -1})), std::vector<int>{});
}

// The wrist straight: any share of the turn between joints 3 and 5 will do.
TEST(Numeric, ReachesSingularPose) {
    const auto robot = numeric();
    const rrs::JointPos q = joint_pos({0.3, 0.8, -0.4, 0.6, 0, -1});
    const rrs::CartPos pose = robot->forward(q);
    const auto found = robot->inverse(pose, joint_pos({0, 0.5, 0, 0, 0.5, 0})).value();
    EXPECT_LT(pose_distance(robot->forward(found), pose), 1e-6);
}

TEST(Numeric, RejectsInvalidInput) {
    EXPECT_FALSE(NumericKinematics::make(Chain(Branch{})));
    EXPECT_FALSE(NumericKinematics::make(arm(), std::vector<JointRange>(5)));
    EXPECT_FALSE(NumericKinematics::make(arm(), std::vector<JointRange>(6, {.min = 1, .max = 0})));
    const auto robot = numeric();
    EXPECT_FALSE(robot->inverse(rrs::CartPos::Identity(), joint_pos({0, 0})));
    rrs::CartPos broken = rrs::CartPos::Identity();
    broken.linear() *= 2;
    EXPECT_FALSE(robot->inverse(broken, rrs::JointPos::Zero(6)));
    EXPECT_FALSE(robot->inverse(pose_from_rpy({.x_mm = 1e300}), rrs::JointPos::Zero(6)));
    EXPECT_TRUE(robot->inverse(robot->forward(rrs::JointPos::Ones(6)), rrs::JointPos::Constant(6, 1e6)));
}

}  // namespace
}  // namespace gsim::kinematics::numeric_test
