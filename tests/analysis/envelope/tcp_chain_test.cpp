#include "analysis/envelope/tcp_chain.h"

#include <string>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::envelope::tip_chain_test {
namespace {

class TcpOfSample : public testing::TestWithParam<const char*> {};

// Joints that are left out, and joints that carry the work, make no difference.
TEST_P(TcpOfSample, MatchesForwardKinematics) {
    const auto machine = machine::load_machine(tests::source_path("samples/machines/") + GetParam());
    ASSERT_TRUE(machine) << machine.error().message;
    const auto kinematics = machine::make_kinematics(*machine);
    const machine::JointBox box = machine::joint_box(*machine);
    const TcpChain chain = tcp_chain(*machine, box);
    for (int number = 1; number <= 100; ++number) {
        const rrs::JointPos joints = box.at(machine::halton_point(number, kinematics->joint_count()));
        std::vector<double> values;
        for (const TcpJoint& joint : chain.joints) values.push_back(joints[joint.joint]);
        EXPECT_LT((chain.tcp(values) - kinematics->forward(joints).translation()).norm(), 1e-8);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, TcpOfSample,
                         testing::Values("router3.toml", "af5.toml", "gantry-offset-head.toml",
                                         "mill-head-table.toml", "mill-table-table.toml", "arm6.toml"));

TEST(TcpChain, OmitsJointsWithoutTcpMotion) {
    const machine::Machine af5 = machine::read_machine(machine::built_in_machine_toml(), "af5").value();
    EXPECT_EQ(tcp_chain(af5, machine::joint_box(af5)).joints.size(), 3U);
    machine::Machine fixed = af5;
    fixed.axes[1].min = fixed.axes[1].max = 100;
    EXPECT_EQ(tcp_chain(fixed, machine::joint_box(fixed)).joints.size(), 2U);
}

TEST(JointBox, LimitsRotationToOneTurnAndCutsUnlimitedRange) {
    machine::Machine machine = machine::read_machine(machine::built_in_machine_toml(), "af5").value();
    machine.axes[0].max = std::numeric_limits<double>::infinity();
    machine.axes[3].home = 300;
    const machine::JointBox box = machine::joint_box(machine);
    EXPECT_EQ(box.cut, std::vector<int>{0});
    EXPECT_DOUBLE_EQ(box.high[0], 1000);
    EXPECT_NEAR(box.low[3], 0, 1e-12);
    EXPECT_NEAR(box.high[3], 2 * M_PI, 1e-12);
    EXPECT_NEAR(box.high[4], M_PI / 2, 1e-12);
}

}  // namespace
}  // namespace gsim::envelope::tip_chain_test
