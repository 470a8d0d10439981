#include "runtime/machine/machine.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "runtime/kinematics/dh_chain.h"
#include "runtime/kinematics/gantry.h"
#include "runtime/kinematics/pose.h"

namespace gsim::machine {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

rrs::CartPos pose(const Frame& frame) {
    return kinematics::pose_from_rpy({.x_mm = frame.x_mm,
                                      .y_mm = frame.y_mm,
                                      .z_mm = frame.z_mm,
                                      .roll_rad = frame.roll_deg * kRadPerDeg,
                                      .pitch_rad = frame.pitch_deg * kRadPerDeg,
                                      .yaw_rad = frame.yaw_deg * kRadPerDeg});
}

kinematics::DhLink link(const Axis& axis) {
    return {.kind = axis.kind == AxisKind::linear ? rrs::JointKind::prismatic : rrs::JointKind::revolute,
            .theta_rad = axis.dh.theta_deg * kRadPerDeg,
            .d_mm = axis.dh.d_mm,
            .a_mm = axis.dh.a_mm,
            .alpha_rad = axis.dh.alpha_deg * kRadPerDeg};
}

kinematics::DhChain chain(const Machine& machine) {
    std::vector<kinematics::DhLink> links;
    std::transform(machine.axes.begin(), machine.axes.end(), std::back_inserter(links), link);
    return {pose(machine.base), links, pose(machine.tool)};
}

}  // namespace

std::optional<std::size_t> Machine::find(char letter) const {
    const auto axis =
        std::find_if(axes.begin(), axes.end(), [letter](const Axis& a) { return a.letter == letter; });
    if (axis == axes.end()) return std::nullopt;
    return static_cast<std::size_t>(axis - axes.begin());
}

double axis_value(const Axis& axis, double joint_value) {
    return axis.zero + (axis.kind == AxisKind::linear ? joint_value : joint_value / kRadPerDeg);
}

double joint_value(const Axis& axis, double axis_value) {
    return (axis_value - axis.zero) * (axis.kind == AxisKind::linear ? 1 : kRadPerDeg);
}

rrs::JointPos home_position(const Machine& machine) {
    rrs::JointPos joints(static_cast<Eigen::Index>(machine.axes.size()));
    Eigen::Index joint = 0;
    for (const Axis& axis : machine.axes) joints[joint++] = joint_value(axis, axis.home);
    return joints;
}

std::optional<std::string> find_kinematic_fault(const Machine& machine) {
    if (machine.axes.size() > static_cast<std::size_t>(rrs::kMaxJoints)) {
        return "A machine has at most " + std::to_string(rrs::kMaxJoints) + " axes.";
    }
    if (machine.inverse != InverseKind::gantry) return std::nullopt;
    const auto gantry = kinematics::GantryKinematics::make(chain(machine));
    if (gantry) return std::nullopt;
    return gantry.error();
}

std::optional<std::string> find_orientation_fault(const Machine& machine) {
    if (machine.controller.orientation == rrs::OrientationRule::joints) return std::nullopt;
    if (!machine.controller.has_great_circles()) {
        return "'orientation = \"great-circle\"' is not for the planner \"linuxcnc\" nor for arcs as chords: "
               "both "
               "plan lines of axis values";
    }
    if (make_kinematics(machine)->tilting_head()) return std::nullopt;
    return "'orientation = \"great-circle\"' needs 'inverse = \"gantry\"' and two rotary axes at right "
           "angles, the "
           "second one also to the tool";
}

std::shared_ptr<const kinematics::Kinematics> make_kinematics(const Machine& machine) {
    if (machine.inverse == InverseKind::none) {
        return std::make_shared<kinematics::ChainKinematics>(chain(machine));
    }
    auto gantry = kinematics::GantryKinematics::make(chain(machine));
    if (!gantry) throw std::invalid_argument(gantry.error());
    return *std::move(gantry);
}

}  // namespace gsim::machine
