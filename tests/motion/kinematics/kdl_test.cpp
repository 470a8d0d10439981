// Forward kinematics against the Orocos Kinematics and Dynamics Library.

#include <gtest/gtest.h>

#include "motion/kinematics/dh_chain.h"
#include "tests/motion/kinematics/kdl_chain.h"
#include "tests/motion/kinematics/random_pose.h"

namespace gsim::kinematics::kdl_test {
namespace {

TEST(KinematicsAgainstKdl, ForwardAgreesForRandomTables) {
    RandomPoses random(7);
    for (int i = 0; i < 3'000; ++i) {
        std::vector<DhLink> rows;
        for (int joint = 0; joint < 6; ++joint) {
            const auto kind =
                random.number(0, 1) < 0.3 ? rrs::JointKind::prismatic : rrs::JointKind::revolute;
            rows.push_back({kind, random.number(-3, 3), random.number(-300, 300), random.number(-300, 300),
                            random.number(-3, 3)});
        }
        const DhChain chain(random.pose(500), rows, random.pose(200));
        const rrs::JointPos q = random.joints(chain);
        ASSERT_LT(pose_distance(chain.forward(q), kdl_forward(chain, q)), 1e-9) << i;
    }
}

TEST(KinematicsAgainstKdl, ForwardAgreesForToolAndWorkChains) {
    RandomPoses random(8);
    for (int i = 0; i < 3'000; ++i) {
        Branch tool{.base = random.pose(500), .links = {}, .end = random.pose(100)};
        Branch work{.base = random.pose(500), .links = {}, .end = random.pose(100)};
        for (int joint = 0; joint < 3; ++joint) {
            tool.links.push_back(random.link(2 * joint, rrs::JointKind::revolute));
            work.links.push_back(random.link(2 * joint + 1, rrs::JointKind::prismatic));
        }
        const Chain chain(tool, work);
        const rrs::JointPos q = random.joints(chain);
        ASSERT_LT(pose_distance(chain.forward(q), kdl_forward(chain, q)), 1e-9) << i;
    }
}

}  // namespace
}  // namespace gsim::kinematics::kdl_test
