#include "machine/model/machine.h"

#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/support/machine_path.h"

namespace gsim::machine::machine_test {
namespace {

Machine af5() {
    return read_machine(built_in_machine_toml(), "af5.toml").value();
}

Eigen::Matrix3d about(double angle_rad, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

TEST(Machine, FindsAxesByLetter) {
    const Machine machine = af5();
    EXPECT_EQ(machine.find('X'), 0u);
    EXPECT_EQ(machine.find('C'), 4u);
    EXPECT_EQ(machine.find('A'), std::nullopt);
}

// The letters as geometry: X Y Z move the TCP along the world's axes, and B turns the tool about the
// vertical. C tilts it about the axis that B carries, and the TCP stays at its position.
TEST(Machine, BuiltInMachineKinematicsAreTransRzRy) {
    const auto kinematics = make_kinematics(af5());
    std::mt19937 random(20);
    std::uniform_real_distribution<double> mm(0, 600), rad(-1.5, 1.5);
    for (int i = 0; i < 200; ++i) {
        rrs::JointPos joints(5);
        joints << mm(random), mm(random), mm(random), 4 * rad(random), rad(random);
        const rrs::CartPos pose = kinematics->forward(joints);
        const Eigen::Matrix3d expected_value =
            about(joints[3], Eigen::Vector3d::UnitZ()) * about(joints[4], Eigen::Vector3d::UnitY());
        EXPECT_LT((pose.translation() - joints.head<3>()).norm(), 1e-9) << joints.transpose();
        EXPECT_LT((pose.linear() - expected_value).norm(), 1e-12) << joints.transpose();
        const auto back = kinematics->inverse(pose, joints);
        ASSERT_TRUE(back) << back.error();
        EXPECT_LT((*back - joints).norm(), 1e-9) << joints.transpose();
    }
}

TEST(Machine, RouterMovesAlongWorldAxes) {
    const Machine machine = load_machine(tests::source_path("samples/machines/router3.toml")).value();
    rrs::JointPos joints(3);
    joints << 10, 20, -30;
    const rrs::CartPos pose = make_kinematics(machine)->forward(joints);
    EXPECT_LT((pose.translation() - Eigen::Vector3d(10, 20, -30)).norm(), 1e-12);
    EXPECT_LT((pose.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

// X Y Z carry the TCP whatever the others do; A B C turn about it; U V W slide along the axes that the rotary
// axes carry.
TEST(Machine, UnlimitedMachineHasNineAxesInUsualDirections) {
    const Machine machine = load_machine(tests::source_path("samples/machines/unlimited.toml")).value();
    std::string letters;
    for (const Axis& axis : machine.axes) {
        letters += axis.letter;
        EXPECT_EQ(axis.min, -std::numeric_limits<double>::infinity()) << axis.letter;
        EXPECT_EQ(axis.max, std::numeric_limits<double>::infinity()) << axis.letter;
    }
    EXPECT_EQ(letters, "XYZABCUVW");
    const auto kinematics = make_kinematics(machine);
    std::mt19937 random(21);
    std::uniform_real_distribution<double> mm(-600, 600), rad(-4, 4);
    for (int i = 0; i < 200; ++i) {
        rrs::JointPos joints(9);
        joints << mm(random), mm(random), mm(random), rad(random), rad(random), rad(random), mm(random),
            mm(random), mm(random);
        const rrs::CartPos pose = kinematics->forward(joints);
        const Eigen::Matrix3d turned = about(joints[3], Eigen::Vector3d::UnitX()) *
                                       about(joints[4], Eigen::Vector3d::UnitY()) *
                                       about(joints[5], Eigen::Vector3d::UnitZ());
        EXPECT_LT((pose.linear() - turned).norm(), 1e-12) << joints.transpose();
        EXPECT_LT((pose.translation() - joints.head<3>() - turned * joints.tail<3>()).norm(), 1e-9)
            << joints.transpose();
    }
}

// B turns about Y and carries C, which turns about Z; both pass through the TCP.
TEST(Machine, LinuxcncMachinesMoveTcpByXyz) {
    std::mt19937 random(22);
    std::uniform_real_distribution<double> mm(-600, 600), rad(-4, 4);
    for (const std::string name : {"linuxcnc-gantry", "linuxcnc-gantry254", "linuxcnc-router",
                                   "linuxcnc-2.10-gantry-pt0", "linuxcnc-2.10-router-pt1-jdef"}) {
        const Machine machine = load_machine(tests::machine_path(name + ".toml")).value();
        const auto kinematics = make_kinematics(machine);
        for (int i = 0; i < 100; ++i) {
            rrs::JointPos joints(5);
            joints << mm(random), mm(random), mm(random), rad(random), rad(random);
            const rrs::CartPos pose = kinematics->forward(joints);
            const Eigen::Matrix3d expected_value =
                about(joints[3], Eigen::Vector3d::UnitY()) * about(joints[4], Eigen::Vector3d::UnitZ());
            EXPECT_LT((pose.translation() - joints.head<3>()).norm(), 1e-9) << joints.transpose();
            EXPECT_LT((pose.linear() - expected_value).norm(), 1e-12) << joints.transpose();
        }
    }
}

TEST(Machine, AxisValuesIncludeZeroOffsetAndUseDegrees) {
    Axis axis{.letter = 'B', .kind = AxisKind::rotary, .zero = 30};
    EXPECT_DOUBLE_EQ(axis_value(axis, std::numbers::pi), 210);
    EXPECT_DOUBLE_EQ(joint_value(axis, 210), std::numbers::pi);
    axis = {.letter = 'Z', .kind = AxisKind::linear, .zero = -100};
    EXPECT_DOUBLE_EQ(axis_value(axis, 25), -75);
    EXPECT_DOUBLE_EQ(joint_value(axis, -75), 25);
}

TEST(Machine, HomePositionIsInJointValues) {
    Machine machine = af5();
    machine.axes[1].home = 50;
    machine.axes[1].zero = 20;
    machine.axes[4].home = 90;
    rrs::JointPos expected_value(5);
    expected_value << 0, 30, 0, 0, std::numbers::pi / 2;
    EXPECT_LT((home_position(machine) - expected_value).norm(), 1e-12);
}

TEST(Machine, RejectsChainUnfitForInverse) {
    Machine machine = af5();
    machine.axes[3].dh.alpha_deg = 0;  // both rotary axes turn about the vertical
    EXPECT_NE(find_kinematic_error(machine), std::nullopt);
    EXPECT_THROW(make_kinematics(machine), std::invalid_argument);
    machine.inverse = InverseKind::none;
    EXPECT_EQ(find_kinematic_error(machine), std::nullopt);
    EXPECT_EQ(make_kinematics(machine)->joint_count(), 5);
}

}  // namespace
}  // namespace gsim::machine::machine_test
