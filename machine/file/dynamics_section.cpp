#include "machine/file/dynamics_section.h"

#include <array>

#include "machine/file/number_list.h"
#include "motion/dynamics/rigid_body.h"

namespace gsim::machine {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;

using std::string_view_literals::operator""sv;

constexpr std::array kDynamicsKeys{"gravity_m_s2"sv, "limit"sv};
constexpr std::array kMassKeys{"on"sv, "mass_kg"sv, "centre_mm"sv, "inertia_kg_m2"sv};
constexpr std::array kHoseKeys{
    "on"sv, "point_mm"sv, "anchor_mm"sv, "free_length_mm"sv, "stiffness_n_per_mm"sv, "drag_n_per_mm_s"sv};
constexpr std::string_view kInertiaMeaning =
    "[xx, yy, zz] or [xx, yy, zz, xy, yz, zx] of the inertia tensor about the centre of mass";

// Names of AccelerationLimit in its order.
constexpr std::array kLimits{"axes"sv, "torque"sv};

using Vector = std::array<double, 3>;

Vector read_vector(TomlSection& section, const toml::table& table, std::string_view key,
                   const Vector& fallback) {
    const auto numbers = read_numbers(section, table, key, "[x, y, z]", {3});
    if (!numbers) return fallback;
    return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

/// Reads the link to which a mass or a hose is attached.
std::string read_link(TomlSection& section, const Machine& machine) {
    std::string on = section.text("on");
    if ((on.size() == 1 && machine.find(on[0])) || on == "tool" || on == "work") return on;
    std::string letters;
    for (const Axis& axis : machine.axes)
        letters += fmt::format("{}{}", letters.empty() ? "" : ", ", axis.letter);
    section.fail("on", fmt::format("'on' must be the letter of an axis ({}), \"tool\" or \"work\"", letters));
    return on;
}

std::array<double, 6> read_inertia(TomlSection& section, const toml::table& table) {
    std::array<double, 6> inertia{};
    const auto numbers = read_numbers(section, table, "inertia_kg_m2", kInertiaMeaning, {3, 6});
    if (!numbers) return inertia;
    std::copy(numbers->begin(), numbers->end(), inertia.begin());
    const auto& [xx, yy, zz, xy, yz, zx] = inertia;
    Eigen::Matrix3d tensor;
    tensor << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    if (const auto error = dynamics::find_inertia_error(tensor))
        section.fail("inertia_kg_m2", fmt::format("'inertia_kg_m2' is not valid for a body: {}", *error));
    return inertia;
}

LinkMass read_mass(FirstError& error, const toml::table& table, const Machine& machine) {
    TomlSection section(error, table, "[[mass]]", kMassKeys);
    LinkMass mass;
    mass.on = read_link(section, machine);
    section.require("mass_kg");
    mass.mass_kg = section.number("mass_kg", 0, NumberRule::not_negative);
    mass.centre_mm = read_vector(section, table, "centre_mm", {});
    mass.inertia_kg_m2 = read_inertia(section, table);
    return mass;
}

HoseTable read_hose(FirstError& error, const toml::table& table, const Machine& machine) {
    TomlSection section(error, table, "[[hose]]", kHoseKeys);
    HoseTable hose;
    hose.on = read_link(section, machine);
    hose.point_mm = read_vector(section, table, "point_mm", {});
    section.require("anchor_mm");
    hose.anchor_mm = read_vector(section, table, "anchor_mm", {});
    hose.free_length_mm = section.number("free_length_mm", 0, NumberRule::not_negative);
    hose.stiffness_n_per_mm = section.number("stiffness_n_per_mm", 0, NumberRule::not_negative);
    hose.drag_n_per_mm_s = section.number("drag_n_per_mm_s", 0, NumberRule::not_negative);
    return hose;
}

/// Checks that no key specifies forces if forces are not computed.
void check_without_dynamics(TomlSection& file, const Machine& machine) {
    const auto fail = [&](std::string_view key, std::string_view what) {
        file.fail(key, fmt::format("{} is for forces and torques, but [dynamics] is missing", what));
    };
    if (file.has("mass")) fail("mass", "[[mass]]");
    if (file.has("hose")) fail("hose", "[[hose]]");
    for (const Axis& axis : machine.axes) {
        if (axis.drive != Drive{}) return fail("axis", fmt::format("the drive of axis {}", axis.letter));
    }
    for (const LinkShape& shape : machine.shapes) {
        if (shape.density_kg_m3 != 0) return fail("shape", fmt::format("the density of '{}'", shape.name));
    }
}

}  // namespace

void read_dynamics(FirstError& error, TomlSection& file, Machine& machine) {
    const toml::table* table = file.table("dynamics");
    if (table == nullptr) return check_without_dynamics(file, machine);
    TomlSection section(error, *table, "[dynamics]", kDynamicsKeys);
    DynamicsTable dynamics;
    dynamics.gravity_m_s2 = read_vector(section, *table, "gravity_m_s2", dynamics.gravity_m_s2);
    dynamics.limit = static_cast<AccelerationLimit>(
        section.choice("limit", static_cast<std::size_t>(dynamics.limit), kLimits));
    if (file.has("mass")) {
        for (const toml::table* mass : file.tables("mass"))
            dynamics.masses.push_back(read_mass(error, *mass, machine));
    }
    if (file.has("hose")) {
        for (const toml::table* hose : file.tables("hose"))
            dynamics.hoses.push_back(read_hose(error, *hose, machine));
    }
    machine.dynamics = std::move(dynamics);
}

void print_dynamics(base::TomlWriter& out, const DynamicsTable& dynamics) {
    out.section("[dynamics]");
    out.line("gravity_m_s2", number_list(dynamics.gravity_m_s2));
    if (dynamics.limit != AccelerationLimit::axes)
        out.line("limit", base::toml_string(kLimits[static_cast<std::size_t>(dynamics.limit)]));
    for (const LinkMass& mass : dynamics.masses) {
        out.section("[[mass]]");
        out.line("on", base::toml_string(mass.on));
        out.number("mass_kg", mass.mass_kg);
        out.line("centre_mm", number_list(mass.centre_mm));
        out.line("inertia_kg_m2", number_list(mass.inertia_kg_m2));
    }
    for (const HoseTable& hose : dynamics.hoses) {
        out.section("[[hose]]");
        out.line("on", base::toml_string(hose.on));
        out.line("point_mm", number_list(hose.point_mm));
        out.line("anchor_mm", number_list(hose.anchor_mm));
        out.number("free_length_mm", hose.free_length_mm);
        out.number("stiffness_n_per_mm", hose.stiffness_n_per_mm);
        out.number("drag_n_per_mm_s", hose.drag_n_per_mm_s);
    }
}

}  // namespace gsim::machine
