#include "runtime/record/tool_position.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/kinematics/pose.h"

namespace gsim::record {

using Eigen::Vector3d;
using machine::AxisKind;
using simulation::AxisVector;

namespace {

constexpr double kStepsPerUnit = 1e9;

}  // namespace

double rounded(double value) {
    return std::round(value * kStepsPerUnit) / kStepsPerUnit + 0.0;  // no -0
}

path::Vector to_path(const Vector3d& vector) {
    return {rounded(vector.x()), rounded(vector.y()), rounded(vector.z())};
}

ToolPosition::ToolPosition(const machine::Machine& machine)
    : machine_(machine), kinematics_(machine::make_kinematics(machine)) {
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        has_rotary_ = has_rotary_ || axis.kind == AxisKind::rotary;
        if (axis.kind == AxisKind::linear && axis.letter >= 'X' && axis.letter <= 'Z') {
            xyz_[static_cast<std::size_t>(axis.letter - 'X')] = static_cast<Eigen::Index>(i);
        }
    }
    has_xyz_ = std::all_of(xyz_.begin(), xyz_.end(), [](Eigen::Index axis) { return axis >= 0; });
}

rrs::CartPos ToolPosition::pose(const AxisVector& axes) const {
    rrs::JointPos joints(axes.size());
    for (Eigen::Index i = 0; i < axes.size(); ++i) {
        joints[i] = machine::joint_value(machine_.axes[static_cast<std::size_t>(i)], axes[i]);
    }
    return kinematics_->forward(joints);
}

Vector3d ToolPosition::tcp(const AxisVector& axes) const {
    return pose(axes).translation();
}

path::Vector ToolPosition::position(const AxisVector& axes) const {
    return to_path(tcp(axes));
}

std::optional<path::Orientation> ToolPosition::orientation(const AxisVector& axes) const {
    if (!has_rotary_) return std::nullopt;
    if (!has_xyz_) {
        const kinematics::Rpy rpy = kinematics::rpy_from_pose(pose(axes));
        return path::RollPitchYaw{rounded(rpy.roll_rad * kDegPerRad), rounded(rpy.pitch_rad * kDegPerRad),
                                  rounded(rpy.yaw_rad * kDegPerRad)};
    }
    path::RotaryAxes rotary;
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        const machine::Axis& axis = machine_.axes[i];
        if (axis.kind == AxisKind::rotary) rotary[axis.letter] = rounded(axes[static_cast<Eigen::Index>(i)]);
    }
    return rotary;
}

Vector3d ToolPosition::xyz(const AxisVector& axes) const {
    Vector3d values = Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (axis(i) >= 0) values[i] = axes[axis(i)];
    }
    return values;
}

bool ToolPosition::is_xyz(Eigen::Index axis) const {
    return std::find(xyz_.begin(), xyz_.end(), axis) != xyz_.end();
}

bool ToolPosition::only_xyz_moves(const AxisVector& from, const AxisVector& to) const {
    for (Eigen::Index i = 0; i < from.size(); ++i) {
        if (!is_xyz(i) && from[i] != to[i]) return false;
    }
    return has_xyz_;
}

bool ToolPosition::moves_other_linear_axes(const AxisVector& from, const AxisVector& to) const {
    for (Eigen::Index i = 0; i < from.size(); ++i) {
        const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(i)];
        if (axis.kind == AxisKind::linear && !is_xyz(i) && from[i] != to[i]) return true;
    }
    return false;
}

}  // namespace gsim::record
