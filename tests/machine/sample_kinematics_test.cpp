// The kinematics of the sample machines: forward against formulas and KDL, inverse against forward.

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "motion/kinematics/chain.h"
#include "tests/build_files/build_files.h"
#include "tests/motion/kinematics/kdl_chain.h"
#include "tests/motion/kinematics/random_pose.h"

namespace gsim::machine::sample_kinematics_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using kinematics::pose_distance;

Machine sample(const std::string& name) {
    return load_machine(tests::source_path("samples/machines/") + name).value();
}

/// Returns joint values over all of the machine's ranges, or two turns for joints without a range.
rrs::JointPos random_joints(const Machine& machine, std::mt19937& random) {
    rrs::JointPos joints(static_cast<Eigen::Index>(machine.axes.size()));
    Eigen::Index joint = 0;
    for (const Axis& axis : machine.axes) {
        const double low = std::isfinite(axis.min) ? axis.min : -360;
        const double high = std::isfinite(axis.max) ? axis.max : 360;
        joints[joint++] = joint_value(axis, std::uniform_real_distribution(low, high)(random));
    }
    return joints;
}

/// Returns the number of poses tried for each machine: `fallback`, or the value in the environment.
int pose_count(int fallback) {
    const char* text = std::getenv("GSIM_POSES");
    return text ? std::atoi(text) : fallback;
}

// FK(IK(pose)) and IK(FK(joints)); the search for a pose starts from its own joints and from others.
void expect_round_trips(const std::string& name, int count, double tolerance) {
    const Machine machine = sample(name);
    const auto kinematics = make_kinematics(machine);
    std::mt19937 random(31);
    for (int i = 0; i < count; ++i) {
        const rrs::JointPos q = random_joints(machine, random);
        const rrs::CartPos pose = kinematics->forward(q);
        const auto same = kinematics->inverse(pose, q);
        ASSERT_TRUE(same) << same.error() << " q " << q.transpose();
        ASSERT_LT((*same - q).cwiseAbs().maxCoeff(), tolerance) << "q " << q.transpose();
        const rrs::JointPos near = random_joints(machine, random);
        const auto other = kinematics->inverse(pose, near);
        ASSERT_TRUE(other) << other.error() << " q " << q.transpose() << " near " << near.transpose();
        ASSERT_LT(pose_distance(kinematics->forward(*other), pose), tolerance)
            << "q " << q.transpose() << " near " << near.transpose();
    }
}

class ClosedForm : public testing::TestWithParam<const char*> {};

TEST_P(ClosedForm, InverseAndForwardAreConsistent) {
    expect_round_trips(GetParam(), pose_count(100'000), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, ClosedForm,
                         testing::Values("af5.toml", "router3.toml", "gantry-offset-head.toml",
                                         "gantry-dynamics.toml", "mill-head-table.toml",
                                         "mill-table-table.toml"),
                         [](const auto& sample) {
                             std::string name = sample.param;
                             for (char& c : name) c = c == '-' || c == '.' ? '_' : c;
                             return name;
                         });

TEST(SampleKinematics, InverseOfArmMatchesForward) {
    expect_round_trips("arm6.toml", pose_count(5'000), 1e-6);
}

TEST(SampleKinematics, ForwardAgreesWithKdl) {
    std::mt19937 random(32);
    for (const char* name : {"af5.toml", "router3.toml", "gantry-offset-head.toml", "mill-head-table.toml",
                             "mill-table-table.toml", "arm6.toml", "unlimited.toml"}) {
        const Machine machine = sample(name);
        const auto kinematics = make_kinematics(machine);
        for (int i = 0; i < 1'000; ++i) {
            const rrs::JointPos q = random_joints(machine, random);
            ASSERT_LT(pose_distance(kinematics->forward(q), kinematics::kdl_forward(kinematics->chain(), q)),
                      1e-9)
                << name << ": " << q.transpose();
        }
    }
}

Eigen::Matrix3d about(double angle_rad, const Vector3d& axis) {
    return AngleAxisd(angle_rad, axis).toRotationMatrix();
}

void expect_pose(const rrs::CartPos& pose, const Vector3d& tcp_mm, const Eigen::Matrix3d& rotation) {
    EXPECT_LT((pose.translation() - tcp_mm).norm(), 1e-9) << pose.translation().transpose();
    EXPECT_LT((pose.linear() - rotation).norm(), 1e-12);
}

// The letters are those of ISO 841: values give the tool's motion against the work, though the table moves.
TEST(SampleKinematics, ForwardOfTableTableMillMatchesFormula) {
    const Machine machine = sample("mill-table-table.toml");
    const auto kinematics = make_kinematics(machine);
    std::mt19937 random(33);
    for (int i = 0; i < 200; ++i) {
        const rrs::JointPos q = random_joints(machine, random);  // X Y Z A C
        const Eigen::Matrix3d turned = about(q[4], Vector3d::UnitZ()) * about(q[3], Vector3d::UnitX());
        const Vector3d axis_height(0, 0, 25);
        expect_pose(kinematics->forward(q), turned * (q.head<3>() + axis_height) - axis_height, turned);
    }
}

TEST(SampleKinematics, ForwardOfHeadTableMillMatchesFormula) {
    const Machine machine = sample("mill-head-table.toml");
    const auto kinematics = make_kinematics(machine);
    std::mt19937 random(34);
    for (int i = 0; i < 200; ++i) {
        const rrs::JointPos q = random_joints(machine, random);  // X Y Z B C
        const Eigen::Matrix3d head = about(q[3], Vector3d::UnitY());
        const Eigen::Matrix3d table = about(q[4], Vector3d::UnitZ());
        const Vector3d arm(0, 0, -180);
        expect_pose(kinematics->forward(q), table * (q.head<3>() - arm + head * arm), table * head);
    }
}

TEST(SampleKinematics, ForwardOfOffsetHeadGantryMatchesFormula) {
    const Machine machine = sample("gantry-offset-head.toml");
    const auto kinematics = make_kinematics(machine);
    std::mt19937 random(35);
    for (int i = 0; i < 200; ++i) {
        const rrs::JointPos q = random_joints(machine, random);  // X Y Z C A
        const Eigen::Matrix3d turn = about(q[3], Vector3d::UnitZ());
        const Eigen::Matrix3d tilt = about(q[4], Vector3d::UnitX());
        const Vector3d at_zero(30, 0, -250);
        const Vector3d arm = turn * (Vector3d(30, 0, 0) + tilt * Vector3d(0, 0, -250));
        expect_pose(kinematics->forward(q), q.head<3>() - at_zero + arm, turn * tilt);
    }
}

}  // namespace
}  // namespace gsim::machine::sample_kinematics_test
