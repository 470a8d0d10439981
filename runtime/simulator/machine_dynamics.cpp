#include "runtime/simulator/machine_dynamics.h"

#include <fmt/format.h>

#include "base/units.h"
#include "collision/cell/body_mass.h"
#include "machine/model/frame_pose.h"
#include "machine/model/torque_limit.h"
#include "motion/dynamics/effort_limits.h"

namespace gsim::simulation {

using dynamics::DynamicsModel;
using dynamics::JointDrive;
using dynamics::RigidBody;

namespace {

constexpr double kMetresPerMm = 1e-3;

Eigen::Vector3d to_metres(const std::array<double, 3>& mm) {
    return kMetresPerMm * Eigen::Vector3d(mm[0], mm[1], mm[2]);
}

RigidBody body_of(const machine::LinkMass& mass) {
    const auto& [xx, yy, zz, xy, yz, zx] = mass.inertia_kg_m2;
    RigidBody body{.mass_kg = mass.mass_kg, .centre_m = to_metres(mass.centre_mm)};
    body.inertia_kg_m2 << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    return body;
}

JointDrive make_joint_drive(const machine::Axis& axis) {
    const double speed_factor = axis.kind == machine::AxisKind::linear ? 1 / kMetresPerMm : kDegPerRad;
    return {.coulomb_friction = axis.drive.coulomb_friction,
            .viscous = axis.drive.viscous * speed_factor,
            .rotor = axis.drive.rotor,
            .counterweight = axis.drive.counterweight};
}

/// Returns the link that carries the masses on a joint, the tool or the work. Returns null for a body that is
/// fixed in the world, because it needs no motor.
RigidBody* find_link(const machine::Machine& machine, const std::string& on, DynamicsModel& model) {
    if (on == "tool") return &model.tool;
    if (on == "work") return &model.work;
    const auto axis = on.size() == 1 ? machine.find(on[0]) : std::nullopt;
    return axis ? &model.links[*axis] : nullptr;
}

std::optional<std::string> add_shapes(const machine::Machine& machine, const cell::MeshFiles& files,
                                      DynamicsModel& model) {
    for (const machine::LinkShape& shape : machine.shapes) {
        RigidBody* link = find_link(machine, shape.on, model);
        if (shape.density_kg_m3 == 0 || link == nullptr) continue;
        const auto body = cell::compute_rigid_body(shape.form, shape.density_kg_m3, files);
        if (!body)
            return fmt::format("the shape '{}' of the machine has no mass: {}", shape.name,
                               body.error().message);
        Eigen::Isometry3d pose = machine::frame_pose(shape.frame);
        pose.translation() *= kMetresPerMm;
        *link = joined(*link, moved(*body, pose));
    }
    return std::nullopt;
}

dynamics::Hose make_hose(const machine::Machine& machine, const machine::HoseTable& table) {
    dynamics::Hose hose{.end = dynamics::HoseEnd::tool,
                        .joint = 0,
                        .point_m = to_metres(table.point_mm),
                        .anchor_m = to_metres(table.anchor_mm),
                        .free_length_m = table.free_length_mm * kMetresPerMm,
                        .stiffness_n_per_m = table.stiffness_n_per_mm / kMetresPerMm,
                        .drag_n_s_per_m = table.drag_n_per_mm_s / kMetresPerMm};
    if (table.on == "work") hose.end = dynamics::HoseEnd::work;
    if (table.on.size() == 1) {
        hose.end = dynamics::HoseEnd::joint;
        hose.joint = static_cast<int>(machine.find(table.on[0]).value());
    }
    return hose;
}

/// If the peaks of motors limit accelerations, each motor must have something to move. This is checked with
/// all axes at home.
std::optional<std::string> find_massless_axis(const machine::Machine& machine,
                                              const dynamics::Dynamics& dynamics) {
    if (!machine::is_torque_limited(machine)) return std::nullopt;
    const rrs::JointPos home = machine::home_position(machine);
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const auto joint = static_cast<Eigen::Index>(i);
        rrs::JointPos unit = rrs::JointPos::Zero(home.size());
        unit[joint] = 1;
        if (!machine::has_motor(machine.axes[i]) || dynamics.inertial_efforts(home, unit)[joint] > 0)
            continue;
        return fmt::format(
            "'limit = \"torque\"' of [dynamics] needs a mass that axis {} moves: define it with a [[mass]], "
            "a density of a [[shape]] or '{}'",
            machine.axes[i].letter,
            machine.axes[i].kind == machine::AxisKind::linear ? "rotor_kg" : "rotor_kg_m2");
    }
    return std::nullopt;
}

dynamics::Motor make_motor(const machine::Axis& axis) {
    std::vector<double> speeds = axis.drive.curve_speeds;
    if (axis.kind == machine::AxisKind::rotary) {
        for (double& speed : speeds) speed *= kRadPerDeg;
    }
    return {axis.drive.peak, speeds, axis.drive.curve_peaks};
}

}  // namespace

tl::expected<std::shared_ptr<const dynamics::Dynamics>, std::string> make_dynamics(
    const machine::Machine& machine, const cell::MeshFiles& files) {
    if (!machine.dynamics) return nullptr;
    DynamicsModel model;
    const auto& [x, y, z] = machine.dynamics->gravity_m_s2;
    model.gravity_m_s2 = {x, y, z};
    model.links.resize(machine.axes.size());
    for (const machine::Axis& axis : machine.axes) model.drives.push_back(make_joint_drive(axis));
    for (const machine::LinkMass& mass : machine.dynamics->masses) {
        RigidBody* link = find_link(machine, mass.on, model);
        if (link != nullptr) *link = joined(*link, body_of(mass));
    }
    for (const machine::HoseTable& hose : machine.dynamics->hoses)
        model.hoses.push_back(make_hose(machine, hose));
    if (auto error = add_shapes(machine, files, model)) return tl::unexpected(*std::move(error));
    auto dynamics = std::make_shared<const dynamics::Dynamics>(make_kinematics(machine)->chain(), model);
    if (auto error = find_massless_axis(machine, *dynamics)) return tl::unexpected(*std::move(error));
    return dynamics;
}

std::shared_ptr<const motion::MoveLimits> make_effort_limits(
    const machine::Machine& machine, std::shared_ptr<const dynamics::Dynamics> dynamics) {
    if (!machine::is_torque_limited(machine) || dynamics == nullptr) return nullptr;
    std::vector<dynamics::Motor> motors;
    for (const machine::Axis& axis : machine.axes) motors.push_back(make_motor(axis));
    return std::make_shared<const dynamics::EffortLimits>(std::move(dynamics), std::move(motors));
}

}  // namespace gsim::simulation
