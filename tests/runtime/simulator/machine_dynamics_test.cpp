// From machine files to forces.
#include "runtime/simulator/machine_dynamics.h"

#include <string>

#include <gtest/gtest.h>

#include "base/units.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::simulation::machine_dynamics_test {
namespace {

using dynamics::Dynamics;

constexpr double kG = 9.80665;

std::shared_ptr<const Dynamics> dynamics_of(const std::string& toml) {
    const auto machine = machine::read_machine(toml, "m.toml");
    EXPECT_TRUE(machine) << machine.error().message;
    const auto dynamics_result = make_dynamics(machine.value());
    EXPECT_TRUE(dynamics_result) << dynamics_result.error();
    return dynamics_result.value();
}

Dynamics::Motion motion(std::initializer_list<double> q, std::initializer_list<double> v,
                        std::initializer_list<double> a) {
    const auto joints = [](std::initializer_list<double> values) {
        rrs::JointPos list(static_cast<Eigen::Index>(values.size()));
        std::copy(values.begin(), values.end(), list.begin());
        return list;
    };
    return {joints(q), joints(v), joints(a), dynamics::motion_directions(joints(v))};
}

TEST(MachineDynamics, IsNullWithoutTable) {
    const auto machine = machine::read_machine(
        "[machine]\nname = \"m\"\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndh = {}\n", "m");
    EXPECT_EQ(make_dynamics(machine.value()).value(), nullptr);
}

TEST(MachineDynamics, SampleGantryMatchesClosedForm) {
    const auto machine = machine::load_machine(tests::source_path("samples/machines/gantry-dynamics.toml"));
    ASSERT_TRUE(machine) << machine.error().message;
    const auto dynamics = make_dynamics(*machine).value();
    const double bridge = 0.16 * 1.6 * 0.22 * 2100;
    // The hose hangs slack at 300 mm above the TCP: 1900 mm up.
    const rrs::JointPos efforts = dynamics->efforts(motion({0, 0, 0}, {500, -400, 100}, {3000, -2000, 1500}));
    EXPECT_NEAR(efforts[0], (bridge + 32 + 14 + 11 + 55) * 3 + 70 + 0.2 * 500 + 0.01 * 500, 1e-9);
    EXPECT_NEAR(efforts[1], -(32 + 14 + 11 + 18) * 2 - 35 - 0.1 * 400 - 0.01 * 400, 1e-9);
    EXPECT_NEAR(efforts[2], (14 + 11 + 9) * 1.5 + (14 + 11) * kG + 25 + 0.1 * 100 + 0.01 * 100 - 220, 1e-9);
}

// A table that slides under the tool and turns: values give the tool's motion against the work, so the table
// moves in the opposite direction, with the same mass.
TEST(MachineDynamics, MovingTableMatchesClosedForm) {
    const auto dynamics = dynamics_of(R"([machine]
name = "m"
[dynamics]
[[axis]]
letter = "X"
kind = "linear"
carries = "work"
direction = "x"
coulomb_n = 10
[[axis]]
letter = "A"
kind = "rotary"
carries = "work"
direction = "x"
viscous_nm_per_deg_s = 0.5
rotor_kg_m2 = 0.2
counterweight_nm = 3
[[axis]]
letter = "Z"
kind = "linear"
direction = "z"
[[mass]]
on = "X"
mass_kg = 100
[[shape]]
name = "plate"
on = "A"
shape = { cylinder_mm = [400, 50] }
frame = { z_mm = 60 }
density_kg_m3 = 7850
[[mass]]
on = "work"
mass_kg = 20
centre_mm = [0, 30, 100]
inertia_kg_m2 = [0.3, 0.3, 0.3]
[[mass]]
on = "tool"
mass_kg = 8
)");
    const double plate = std::numbers::pi * 0.2 * 0.2 * 0.05 * 7850;
    const double moment =
        plate * ((3 * 0.04 + 0.0025) / 12 + 0.06 * 0.06) + 0.3 + 20 * (0.03 * 0.03 + 0.1 * 0.1);
    const double speed = 40 * kRadPerDeg;
    const rrs::JointPos efforts = dynamics->efforts(motion({0, 0, 0}, {100, speed, 0}, {2000, 5, 1000}));
    EXPECT_NEAR(efforts[0], (100 + plate + 20) * 2 + 10, 1e-9);
    // A counts how the tool turns against the work: the work turns about -X as it grows, and so lowers a mass
    // that lies along Y.
    EXPECT_NEAR(efforts[1], (moment + 0.2) * 5 - 20 * kG * 0.03 + 0.5 * 40 - 3, 1e-9);
    EXPECT_NEAR(efforts[2], 8 * (1 + kG), 1e-9);
}

TEST(MachineDynamics, ReportsOpenMeshByName) {
    const auto machine =
        machine::read_machine(R"([machine]
name = "m"
[dynamics]
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
[[shape]]
name = "sheet"
on = "X"
shape = { mesh = "sheet.obj" }
density_kg_m3 = 7850
)",
                              "m.toml", os::CallbackFiles([](const std::string&) { return "v 0 0 0\n"; }));
    ASSERT_TRUE(machine) << machine.error().message;
    const os::CallbackFiles sheet([](const std::string&) { return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; });
    const auto dynamics_result = make_dynamics(*machine, {.files = sheet});
    ASSERT_FALSE(dynamics_result);
    EXPECT_EQ(dynamics_result.error(),
              "the shape 'sheet' of the machine has no mass: sheet.obj: the surface is not closed, so it "
              "encloses no mass: an edge at 0 0 0 has a triangle on one side only");
}

}  // namespace
}  // namespace gsim::simulation::machine_dynamics_test
