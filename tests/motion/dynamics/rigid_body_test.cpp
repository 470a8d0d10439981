#include "motion/dynamics/rigid_body.h"

#include <gmock/gmock.h>

#include "tests/motion/dynamics/models.h"

namespace gsim::dynamics {
namespace {

TEST(RigidBody, JoinsTwoCubesIntoBar) {
    // Two cubes of 1 m and 2 kg side by side are a bar of 2 m along X and 4 kg.
    const RigidBody cube{.mass_kg = 2,
                         .centre_m = {0.5, 0, 0},
                         .inertia_kg_m2 = Eigen::Vector3d::Constant(2.0 / 6).asDiagonal()};
    Eigen::Isometry3d further = Eigen::Isometry3d::Identity();
    further.translation().x() = 1;
    const RigidBody bar = joined(cube, moved(cube, further));
    EXPECT_DOUBLE_EQ(bar.mass_kg, 4);
    EXPECT_TRUE(bar.centre_m.isApprox(Eigen::Vector3d(1, 0, 0)));
    const Eigen::Vector3d moments(4.0 / 6, 4 * (4 + 1) / 12.0, 4 * (4 + 1) / 12.0);
    EXPECT_TRUE(bar.inertia_kg_m2.isApprox(Eigen::Matrix3d(moments.asDiagonal()))) << bar.inertia_kg_m2;
}

TEST(RigidBody, InertiaTurnsWithFrame) {
    const RigidBody rod{.mass_kg = 1, .inertia_kg_m2 = Eigen::Vector3d(0, 1, 1).asDiagonal()};
    Eigen::Isometry3d quarter = Eigen::Isometry3d::Identity();
    quarter.linear() = Eigen::AngleAxisd(kinematics::kQuarter, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d along_y = Eigen::Vector3d(1, 0, 1).asDiagonal();
    EXPECT_TRUE(moved(rod, quarter).inertia_kg_m2.isApprox(along_y, 1e-15));
}

TEST(RigidBody, JoiningEmptyBodiesGivesEmptyBody) {
    EXPECT_EQ(joined({}, {}).mass_kg, 0);
    EXPECT_TRUE(joined({}, {}).centre_m.isZero());
}

TEST(RigidBody, AcceptsOnlyPhysicalInertiaTensors) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(find_inertia_error(random.body().inertia_kg_m2), std::nullopt);
    // A rod without thickness is the limit of bodies.
    EXPECT_EQ(find_inertia_error(Eigen::Vector3d(0, 2, 2).asDiagonal()), std::nullopt);
    EXPECT_EQ(find_inertia_error(Eigen::Vector3d(-0.5, 2, 2).asDiagonal()),
              "one of its principal moments is negative: -0.5 kg m2");
    EXPECT_EQ(find_inertia_error(Eigen::Vector3d(1, 2, 4).asDiagonal()),
              "its principal moment 4 kg m2 is greater than the sum of the two others, 1 and 2");
}

}  // namespace
}  // namespace gsim::dynamics
