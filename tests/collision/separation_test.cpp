#include "collision/pairs/separation.h"

#include <random>

#include <gtest/gtest.h>

#include "collision/cell/machine_shapes.h"
#include "collision/pairs/candidate_pairs.h"
#include "machine/model/joint_box.h"
#include "tests/build_files/build_files.h"
#include "tests/collision/segments.h"

namespace gsim::cell::separation_test {
namespace {

Body box_on(const Shape& shape, int link, const Eigen::Vector3d& at_mm) {
    return {&shape, link, Eigen::Isometry3d(Eigen::Translation3d(at_mm))};
}

TEST(Separation, IsGapAlongDirection) {
    const Shape box = Shape::box({10, 20, 30});
    const Shape ball = Shape::sphere(8);
    const LinkFrames links{rrs::CartPos::Identity()};
    const Body first = box_on(box, 0, {0, 0, 100});
    const Body second = box_on(ball, 0, {0, 0, 0});
    EXPECT_NEAR(distance_along_mm(first, second, links, Eigen::Vector3d::UnitZ()), 100 - 15 - 4, 1e-12);
    EXPECT_NEAR(distance_along_mm(first, second, links, Eigen::Vector3d::UnitX()), -5 - 4, 1e-12);
    EXPECT_NEAR(distance_along_mm(second, first, links, -Eigen::Vector3d::UnitZ()), 100 - 15 - 4, 1e-12);
}

// A head that slides along a table and turns about the normal of the table comes no nearer to it.
TEST(Separation, PerpendicularTravelCostsNothing) {
    const auto kinematics = machine::make_kinematics(af5());
    const rrs::JointPos middle = joints(900, 1200, 300);
    rrs::JointPos half = joints(900, 1200, 300, 3.0);
    const std::vector<JointAxis> axes = joint_axes(*kinematics, middle);
    const std::vector<int> from_tool{4, 3, 2, 1, 0};
    const auto ways =
        travels_along_mm({{900, 1200, 400}, 50}, {axes, half}, from_tool, Eigen::Vector3d::UnitZ());
    ASSERT_EQ(ways.size(), 5U);
    EXPECT_EQ(ways[0], 0) << "C stands";
    EXPECT_NEAR(ways[2], 300, 1e-9) << "Z goes all along it";
    EXPECT_NEAR(ways[3], 0, 1e-9);
    EXPECT_NEAR(ways[4], 0, 1e-9);
}

// No configuration in the part comes nearer along the direction than the distances allow, and the direction
// moves with the second body.
TEST(Separation, HoldsInRandomJointBoxes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const char* file : {"arm6.toml", "mill-table-table.toml"}) {
        const machine::Machine machine =
            machine::load_machine(tests::source_path("samples/machines/") + file).value();
        const auto kinematics = machine::make_kinematics(machine);
        const machine::JointBox box = machine::joint_box(machine);
        const Cell cell = make_machine_cell(machine).value();
        for (const CandidatePair& pair : candidate_pairs(cell, *kinematics)) {
            const Body& first = pair.bodies.first;
            const Body& second = pair.bodies.second;
            for (int round = 0; round < 60; ++round) {
                const double size = std::pow(10, 1.5 * unit(random) - 1.5);
                rrs::JointPos middle = (box.low + box.high) / 2;
                for (double& value : middle) value *= 1 + 0.3 * unit(random);
                const rrs::JointPos half = size * (box.high - box.low) / 2;
                const LinkFrames links = link_frames(*kinematics, middle);
                const std::vector<JointAxis> axes = joint_axes(*kinematics, middle);
                const Eigen::Vector3d direction =
                    Eigen::Vector3d(unit(random), unit(random), unit(random)).normalized();
                double min_mm = distance_along_mm(first, second, links, direction);
                for (const double distance :
                     travels_along_mm(first.ball(links), {axes, half}, pair.bodies.between, direction))
                    min_mm -= distance;
                const Eigen::Vector3d local = second.pose_in_world(links).linear().transpose() * direction;
                for (int configuration_index = 0; configuration_index < 30; ++configuration_index) {
                    rrs::JointPos at = middle;
                    for (Eigen::Index joint = 0; joint < at.size(); ++joint)
                        at[joint] +=
                            half[joint] *
                            (configuration_index < 10 ? std::copysign(1.0, unit(random)) : unit(random));
                    const LinkFrames there = link_frames(*kinematics, at);
                    const Eigen::Vector3d turned = second.pose_in_world(there).linear() * local;
                    ASSERT_GE(distance_along_mm(first, second, there, turned), min_mm - 1e-9)
                        << file << ", round " << round;
                }
            }
        }
    }
}

}  // namespace
}  // namespace gsim::cell::separation_test
