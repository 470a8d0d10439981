#include "runtime/simulator/program/program_position.h"

#include <cmath>

namespace gsim::simulation {

namespace {

/// mm or deg: rounding error of rotation and scaling for an axis that does not move.
constexpr double kMinTravel = 1e-9;

std::array<int, 3> xyz_axes(const machine::Machine& machine) {
    std::array<int, 3> axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto axis = machine.find(static_cast<char>('X' + i));
        axes[i] = axis ? static_cast<int>(*axis) : -1;
    }
    return axes;
}

}  // namespace

ProgramPosition::ProgramPosition(const machine::Machine& machine, const motion::PlannerSetup& setup)
    : machine_(machine),
      setup_(setup),
      xyz_axes_(xyz_axes(machine)),
      axes_(static_cast<Eigen::Index>(machine.axes.size())) {
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        axes_[static_cast<Eigen::Index>(i)] = machine.axes[i].home;
}

rrs::JointPos ProgramPosition::to_joints(const AxisVector& axes) const {
    rrs::JointPos joints(axes.size());
    for (Eigen::Index i = 0; i < axes.size(); ++i)
        joints[i] = machine::joint_value(machine_.axes[static_cast<std::size_t>(i)], axes[i]);
    return joints;
}

AxisVector ProgramPosition::to_axes(const rrs::JointPos& joints) const {
    AxisVector axes(joints.size());
    for (Eigen::Index i = 0; i < joints.size(); ++i)
        axes[i] = machine::axis_value(machine_.axes[static_cast<std::size_t>(i)], joints[i]);
    return axes;
}

tl::expected<rrs::JointPos, std::string> ProgramPosition::solve_joints(const AxisVector& target) const {
    if (tcp_frame_) return tcp_frame_->joints(setup_, to_joints(target));
    return to_joints(target);
}

AxisVector ProgramPosition::at(const rrs::JointPos& joints) const {
    return to_axes(tcp_frame_ ? tcp_frame_->coordinates(setup_, joints) : joints);
}

motion::Circle ProgramPosition::circle(const ArcMove& move) const {
    Eigen::Vector3d center = move.center_mm;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int at = xyz_axes_[static_cast<std::size_t>(i)];
        if (at >= 0) center[i] -= machine_.axes[static_cast<std::size_t>(at)].zero;
    }
    Eigen::Vector3d axis = move.axis();
    if (tcp_frame_) {
        center = tcp_frame_->point(center);
        axis = tcp_frame_->turn_axis(axis);
    }
    return motion::Circle{center, axis, move.sweep_rad};
}

Eigen::Vector3d ProgramPosition::space_point(const AxisVector& axes) const {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const int axis = xyz_axes_[static_cast<std::size_t>(i)];
        if (axis >= 0) point[i] = axes[axis];
    }
    return point;
}

bool ProgramPosition::is_rotary_only(const AxisVector& target) const {
    bool rotary = false;
    for (Eigen::Index i = 0; i < target.size(); ++i) {
        if (std::abs(target[i] - axes_[i]) < kMinTravel) continue;
        if (machine_.axes[static_cast<std::size_t>(i)].kind == machine::AxisKind::linear) return false;
        rotary = true;
    }
    return rotary;
}

}  // namespace gsim::simulation
