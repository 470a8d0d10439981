// A controller module receives the complete kinematics of a machine.

#include "runtime/rcs/rcs_machine.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "runtime/simulator/make_planner_setup.h"
#include "tests/build_files/build_files.h"

namespace gsim::simulation::rcs_machine_test {
namespace {

rrs::JointPos random_joints(const motion::PlannerSetup& setup, std::mt19937& random) {
    rrs::JointPos joints(setup.joint_count());
    for (int i = 0; i < setup.joint_count(); ++i) {
        const bool slide = setup.joints[static_cast<std::size_t>(i)].kind == rrs::JointKind::prismatic;
        joints[i] = std::uniform_real_distribution(slide ? 0.0 : -0.5, slide ? 200.0 : 0.5)(random);
    }
    return joints;
}

TEST(RcsMachine, PassesKinematicsOfSampleMachines) {
    std::mt19937 random(51);
    for (const std::string name : {"af5", "router3", "gantry-offset-head", "mill-head-table",
                                   "mill-table-table", "arm6", "unlimited"}) {
        const machine::Machine machine =
            machine::load_machine(tests::source_path("samples/machines/") + name + ".toml").value();
        const motion::PlannerSetup setup = make_planner_setup(machine);
        const rcs::RcsMachine described(setup);
        const auto reported = rcs::setup_from_rcs_machine(described.get());
        ASSERT_TRUE(reported) << name << ": " << reported.error().message;
        ASSERT_EQ(reported->kinematics->inverse_kind(), setup.kinematics->inverse_kind()) << name;
        for (int i = 0; i < 100; ++i) {
            const rrs::JointPos q = random_joints(setup, random);
            const rrs::CartPos pose = setup.kinematics->forward(q);
            ASSERT_LT((reported->kinematics->forward(q).matrix() - pose.matrix()).norm(), 1e-9) << name;
            if (!setup.kinematics->has_inverse()) continue;
            const auto back = reported->kinematics->inverse(pose, q);
            ASSERT_TRUE(back) << name << ": " << back.error();
            ASSERT_LT((*back - q).norm(), 1e-6) << name;
        }
    }
}

TEST(RcsMachine, RejectsRowsNotNumberedFromZero) {
    const motion::PlannerSetup setup =
        make_planner_setup(machine::read_machine(machine::built_in_machine_toml(), "").value());
    gsim_rcs_machine described = rcs::RcsMachine(setup).get();
    described.parameter_count = 0;
    described.joints[1].row = 0;
    EXPECT_EQ(rcs::setup_from_rcs_machine(described).error().message,
              "The rows of the joints must be numbered from 0 up.");
    described.joints[1].row = 7;
    EXPECT_FALSE(rcs::setup_from_rcs_machine(described));
}

}  // namespace
}  // namespace gsim::simulation::rcs_machine_test
