// Masses, friction and motors in machine files.

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::dynamics_section_test {
namespace {

constexpr std::string_view kFileHeader = R"([machine]
name = "m"
[dynamics]
)";
constexpr std::string_view kAxes = R"([[axis]]
letter = "X"
kind = "linear"
direction = "x"
[[axis]]
letter = "B"
kind = "rotary"
direction = "y"
)";

std::string error_of(const std::string& toml) {
    const auto machine = read_machine(toml, "m.toml");
    return machine ? "no error" : machine.error().message;
}

/// Returns a machine with dynamics that ends with `lines`; the first of these lines is line 12.
std::string with(std::string_view lines) {
    return fmt::format("{}{}{}\n", kFileHeader, kAxes, lines);
}

TEST(DynamicsSection, ReadsAndPrintsAllKeys) {
    const std::string text = R"([machine]
name = "m"
[dynamics]
gravity_m_s2 = [0, -9.81, 0.5]
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
coulomb_n = 1
viscous_n_per_mm_s = 0.2
rotor_kg = 3
counterweight_n = -4
peak_n = 50
continuous_n = 16
curve_speed_mm_s = [0, 100, 200]
curve_peak_n = [50, 50, 20.5]
[[axis]]
letter = "B"
kind = "rotary"
direction = "y"
coulomb_nm = 7
viscous_nm_per_deg_s = 0.8
rotor_kg_m2 = 9
counterweight_nm = 10
peak_nm = 11
continuous_nm = 12
curve_speed_deg_s = [30]
curve_peak_nm = [11]
[[shape]]
name = "ball"
on = "X"
shape = { sphere_mm = 100 }
density_kg_m3 = 7850
[[mass]]
on = "B"
mass_kg = 12.5
centre_mm = [1, 2, 3]
inertia_kg_m2 = [1, 1.5, 2, 0.1, 0.2, 0.3]
[[mass]]
on = "work"
mass_kg = 2
inertia_kg_m2 = [1, 1, 1]
[[hose]]
on = "tool"
point_mm = [0, 0, 10]
anchor_mm = [0, 0, 1000]
free_length_mm = 800
stiffness_n_per_mm = 0.05
drag_n_per_mm_s = 0.01
)";
    const auto machine = read_machine(text, "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->axes[0].drive, (Drive{1, 0.2, 3, -4, 50, 16, {0, 100, 200}, {50, 50, 20.5}}));
    EXPECT_EQ(machine->axes[1].drive, (Drive{7, 0.8, 9, 10, 11, 12, {30}, {11}}));
    EXPECT_EQ(machine->shapes[0].density_kg_m3, 7850);
    const DynamicsTable expected_value{.gravity_m_s2 = {0, -9.81, 0.5},
                                       .masses = {{.on = "B",
                                                   .mass_kg = 12.5,
                                                   .centre_mm = {1, 2, 3},
                                                   .inertia_kg_m2 = {1, 1.5, 2, 0.1, 0.2, 0.3}},
                                                  {.on = "work", .mass_kg = 2, .inertia_kg_m2 = {1, 1, 1}}},
                                       .hoses = {{.on = "tool",
                                                  .point_mm = {0, 0, 10},
                                                  .anchor_mm = {0, 0, 1000},
                                                  .free_length_mm = 800,
                                                  .stiffness_n_per_mm = 0.05,
                                                  .drag_n_per_mm_s = 0.01}}};
    EXPECT_EQ(machine->dynamics, expected_value);
    const auto repeated = read_machine(print_machine(*machine), "printed.toml");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine);
}

TEST(DynamicsSection, EmptyTableMeansStandardGravityOnly) {
    const Machine machine = read_machine(with(""), "m.toml").value();
    ASSERT_TRUE(machine.dynamics);
    EXPECT_EQ(*machine.dynamics, DynamicsTable{});
    EXPECT_EQ(machine.dynamics->gravity_m_s2[2], -9.80665);
    EXPECT_EQ(read_machine(fmt::format("[machine]\nname = \"m\"\n{}", kAxes), "m.toml")->dynamics,
              std::nullopt);
}

TEST(DynamicsSection, RejectsImpossibleMasses) {
    EXPECT_EQ(error_of(with("[[mass]]\non = \"X\"\nmass_kg = -1")),
              "m.toml:14:11: 'mass_kg' must be 0 or greater, not -1");
    EXPECT_EQ(error_of(with("[[mass]]\non = \"X\"")), "m.toml:12:1: [[mass]] lacks the key 'mass_kg'");
    EXPECT_EQ(error_of(with("[[mass]]\non = \"X\"\nmass_kg = 1\ninertia_kg_m2 = [1, 2, 4]")),
              "m.toml:15:17: 'inertia_kg_m2' is not valid for a body: its principal moment 4 kg m2 is "
              "greater than the sum of the two others, 1 and 2");
    EXPECT_EQ(error_of(with("[[mass]]\non = \"X\"\nmass_kg = 1\ninertia_kg_m2 = [1, 1, 1, 2, 0, 0]")),
              "m.toml:15:17: 'inertia_kg_m2' is not valid for a body: one of its principal moments is "
              "negative: -1 kg m2");
    EXPECT_EQ(error_of(with("[[mass]]\non = \"X\"\nmass_kg = 1\ninertia_kg_m2 = [1, 2]")),
              "m.toml:15:17: 'inertia_kg_m2' must be [xx, yy, zz] or [xx, yy, zz, xy, yz, zx] of the inertia "
              "tensor about the centre of mass, numbers between -1e9 and 1e9");
    EXPECT_EQ(error_of(with("[[mass]]\non = \"X\"\nmass_kg = 1\ncentre_mm = [1, \"2\", 3]")),
              "m.toml:15:13: 'centre_mm' must be [x, y, z], numbers between -1e9 and 1e9");
}

TEST(DynamicsSection, RejectsUnknownLinks) {
    for (const char* on : {"Y", "base", "jet", ""}) {
        EXPECT_EQ(error_of(with(fmt::format("[[mass]]\non = \"{}\"\nmass_kg = 1", on))),
                  "m.toml:13:6: 'on' must be the letter of an axis (X, B), \"tool\" or \"work\"");
    }
    EXPECT_EQ(error_of(with("[[hose]]\non = \"tool\"")), "m.toml:12:1: [[hose]] lacks the key 'anchor_mm'");
}

TEST(DynamicsSection, RejectsInvalidMotorCurves) {
    const auto axis = [](std::string_view lines) {
        return fmt::format("{}[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndirection = \"x\"\n{}\n",
                           kFileHeader, lines);
    };
    EXPECT_EQ(error_of(axis("curve_speed_mm_s = [0]")),
              "m.toml:8:20: a motor curve needs 'curve_speed_mm_s' and 'curve_peak_n', but 'curve_peak_n' is "
              "missing");
    EXPECT_EQ(error_of(axis("curve_speed_mm_s = [0, 1]\ncurve_peak_n = [1]")),
              "m.toml:9:16: 'curve_peak_n' and 'curve_speed_mm_s' must have the same number of values, at "
              "least one; they have 1 and 2");
    EXPECT_EQ(error_of(axis("curve_speed_mm_s = [0, 0]\ncurve_peak_n = [1, 1]")),
              "m.toml:8:20: 'curve_speed_mm_s' must be speeds from 0 up, in ascending order");
    EXPECT_EQ(error_of(axis("curve_speed_mm_s = [0]\ncurve_peak_n = [-1]")),
              "m.toml:9:16: 'curve_peak_n' must be 0 or greater; -1 is not");
    EXPECT_EQ(error_of(axis("coulomb_nm = 1")),
              "m.toml:8:1: unknown key 'coulomb_nm' in a linear [[axis]]; did you mean 'coulomb_n'?");
}

TEST(DynamicsSection, RejectsForcesWithoutDynamicsTable) {
    const auto without = [](std::string_view lines) {
        return error_of(fmt::format("[machine]\nname = \"m\"\n{}{}\n", kAxes, lines));
    };
    EXPECT_EQ(without("peak_nm = 3"),
              "m.toml:3:1: the drive of axis B is for forces and torques, but [dynamics] is missing");
    EXPECT_EQ(without("[[mass]]\non = \"X\"\nmass_kg = 1"),
              "m.toml:11:1: [[mass]] is for forces and torques, but [dynamics] is missing");
    EXPECT_EQ(without("[[shape]]\nname = \"s\"\non = \"X\"\nshape = { sphere_mm = 1 }\ndensity_kg_m3 = 1"),
              "m.toml:11:1: the density of 's' is for forces and torques, but [dynamics] is missing");
}

}  // namespace
}  // namespace gsim::machine::dynamics_section_test
