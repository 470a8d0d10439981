#include "toolpath/rotary/machine_space.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "motion/kinematics/pose.h"
#include "toolpath/model/arc_shape.h"

namespace gsim::path {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using machine::AxisKind;

constexpr double kCouplingTolerance_mm = 1e-9;
constexpr double kRangeTolerance = 1e-6;  // mm or deg that an axis may be beyond its range by rounding

// Clears rounding errors of zero, which would show as -0.000.
double snap_to_zero(double value) {
    return std::abs(value) < 1e-10 ? 0.0 : value;
}

// Returns that rotation, turned by the smallest angle, so that Z points in a direction of length 1. Eigen's
// FromTwoVectors() is avoided, because it takes three seconds to compile.
Eigen::Matrix3d rotate_to_axis(const Eigen::Matrix3d& rotation, const Vector3d& direction) {
    const Vector3d z = rotation.col(2);
    const Vector3d across = z.cross(direction);
    const double sine = across.norm();
    const Vector3d about = sine > 0 ? Vector3d(across / sine) : Vector3d(rotation.col(0));
    return Eigen::AngleAxisd(std::atan2(sine, z.dot(direction)), about) * rotation;
}

AxisValues pair(double first, double second) {
    AxisValues values(2);
    values[0] = first;
    values[1] = second;
    return values;
}

}  // namespace

Result<MachineSpace> MachineSpace::make(const machine::Machine& machine) {
    MachineSpace space(machine);
    std::size_t linear_count = 0;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        if (axis.kind == AxisKind::rotary) {
            space.rotary_.push_back(i);
        } else if (axis.letter >= 'X' && axis.letter <= 'Z') {
            space.linear_[static_cast<std::size_t>(axis.letter - 'X')] = i;
            ++linear_count;
        }
    }
    if (linear_count != 3) {
        return Unexpected(
            fmt::format("the machine '{}' lacks the linear axes X, Y and Z, by which programs of a path "
                        "position the tool",
                        machine.name));
    }
    space.kinematics_ = machine::make_kinematics(machine);
    space.analyze();
    if (std::abs(space.to_linear_.determinant()) < 0.5 || !space.to_linear_.allFinite()) {
        return Unexpected(fmt::format(
            "X, Y and Z of the machine '{}' do not move the tool in three directions", machine.name));
    }
    return space;
}

// Relies on the TCP being an affine function of the linear axes, for any values of the rotary ones.
void MachineSpace::analyze() {
    const auto affine = [this](const AxisValues& rotary, Vector3d& origin) {
        AxisValues at = with_rotary(rotary);
        origin = tcp(at);
        Matrix3d directions;
        for (std::size_t i = 0; i < 3; ++i) {
            AxisValues moved = at;
            moved[static_cast<Eigen::Index>(linear_[i])] += 1;
            directions.col(static_cast<Eigen::Index>(i)) = tcp(moved) - origin;
        }
        return Matrix3d(directions.inverse());
    };
    AxisValues rotary = AxisValues::Zero(static_cast<Eigen::Index>(rotary_.size()));
    to_linear_ = affine(rotary, tcp_at_zero_);
    is_coupled_ = false;
    for (const double angle : {31.0, 77.0, -53.0}) {
        for (Eigen::Index i = 0; i < rotary.size(); ++i) {
            rotary[i] = angle + 11.0 * static_cast<double>(i);
            Vector3d origin;
            const Matrix3d turned = affine(rotary, origin);
            is_coupled_ = is_coupled_ || (origin - tcp_at_zero_).norm() > kCouplingTolerance_mm ||
                          (turned - to_linear_).norm() > kCouplingTolerance_mm;
        }
    }
}

rrs::JointPos MachineSpace::joints(const AxisValues& axes) const {
    rrs::JointPos joints(axes.size());
    for (Eigen::Index i = 0; i < axes.size(); ++i) {
        joints[i] = machine::joint_value(machine_->axes[static_cast<std::size_t>(i)], axes[i]);
    }
    return joints;
}

Vector3d MachineSpace::tcp(const AxisValues& axes) const {
    return kinematics_->forward(joints(axes)).translation();
}

Vector3d MachineSpace::tool_axis(const AxisValues& axes) const {
    return kinematics_->forward(joints(axes)).linear().col(2);
}

AxisValues MachineSpace::home() const {
    AxisValues values(static_cast<Eigen::Index>(machine_->axes.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        values[i] = machine_->axes[static_cast<std::size_t>(i)].home;
    }
    return values;
}

AxisValues MachineSpace::home_rotary() const {
    AxisValues values(static_cast<Eigen::Index>(rotary_.size()));
    for (std::size_t i = 0; i < rotary_.size(); ++i) {
        values[static_cast<Eigen::Index>(i)] = rotary_axis(i).home;
    }
    return values;
}

// Leaves the linear axes at 0 and others at home.
AxisValues MachineSpace::with_rotary(const AxisValues& rotary) const {
    AxisValues values = home();
    for (const std::size_t axis : linear_) values[static_cast<Eigen::Index>(axis)] = 0;
    for (std::size_t i = 0; i < rotary_.size(); ++i) {
        values[static_cast<Eigen::Index>(rotary_[i])] = rotary[static_cast<Eigen::Index>(i)];
    }
    return values;
}

AxisValues MachineSpace::axes(const Vector3d& tcp_mm, const AxisValues& rotary) const {
    AxisValues values = with_rotary(rotary);
    Vector3d linear;
    if (!is_coupled_) {
        linear = to_linear_ * (tcp_mm - tcp_at_zero_);
    } else {
        const Vector3d origin = tcp(values);
        Matrix3d directions;
        for (std::size_t i = 0; i < 3; ++i) {
            AxisValues moved = values;
            moved[static_cast<Eigen::Index>(linear_[i])] += 1;
            directions.col(static_cast<Eigen::Index>(i)) = tcp(moved) - origin;
        }
        linear = directions.inverse() * (tcp_mm - origin);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        values[static_cast<Eigen::Index>(linear_[i])] = snap_to_zero(linear[static_cast<Eigen::Index>(i)]);
    }
    return values;
}

Vector3d MachineSpace::linear(const AxisValues& axes) const {
    return {axes[static_cast<Eigen::Index>(linear_[0])], axes[static_cast<Eigen::Index>(linear_[1])],
            axes[static_cast<Eigen::Index>(linear_[2])]};
}

// Keeps the rotation about the tool axis as in `from`, as far as possible, if the orientation is only an
// axis. Another rotation, which the inverse kinematics may reach exactly, would draw the axes away from
// nearby values.
rrs::CartPos MachineSpace::tool_pose(const Vector3d& tcp_mm, const Orientation& orientation,
                                     const rrs::JointPos& from) const {
    rrs::CartPos pose;
    if (const auto* axis = std::get_if<ToolAxis>(&orientation)) {
        pose.linear() =
            rotate_to_axis(kinematics_->forward(from).linear(), to_eigen(axis->direction).normalized());
    } else {
        const auto& rpy = std::get<RollPitchYaw>(orientation);
        pose = kinematics::pose_from_rpy(
            {0, 0, 0, rpy.roll_deg * kRadPerDeg, rpy.pitch_deg * kRadPerDeg, rpy.yaw_deg * kRadPerDeg});
    }
    pose.translation() = tcp_mm;
    return pose;
}

Result<std::vector<AxisValues>> MachineSpace::solve_rotary(const Vector& tcp_mm,
                                                           const Orientation& orientation,
                                                           const AxisValues& near) const {
    const Vector3d tcp = to_eigen(tcp_mm);
    std::vector<AxisValues> starts;
    starts.reserve(3);
    starts.push_back(near);
    if (rotary_.size() == 2) {
        starts.push_back(pair(near[0] + 180, -near[1]));
        starts.push_back(pair(-near[0], near[1] + 180));
    }
    std::vector<AxisValues> found;
    std::string error;
    for (const AxisValues& start : starts) {
        const rrs::JointPos from = joints(axes(tcp, start));
        const auto solution = kinematics_->inverse(tool_pose(tcp, orientation, from), from);
        if (!solution) {
            if (error.empty()) error = solution.error();
            continue;
        }
        AxisValues values(static_cast<Eigen::Index>(rotary_.size()));
        for (std::size_t i = 0; i < rotary_.size(); ++i) {
            values[static_cast<Eigen::Index>(i)] = snap_to_zero(
                machine::axis_value(rotary_axis(i), (*solution)[static_cast<Eigen::Index>(rotary_[i])]));
        }
        found.push_back(values);
    }
    if (found.empty()) return tl::unexpected(error);
    return found;
}

std::optional<Error> MachineSpace::find_axis_range_error(const AxisValues& axes) const {
    for (Eigen::Index i = 0; i < axes.size(); ++i) {
        const machine::Axis& axis = machine_->axes[static_cast<std::size_t>(i)];
        if (axes[i] >= axis.min - kRangeTolerance && axes[i] <= axis.max + kRangeTolerance) continue;
        return fmt::format("out of reach: {} {:.6g} is outside {:.6g} to {:.6g}", axis.letter,
                           text::unsigned_zero(axes[i]), text::unsigned_zero(axis.min),
                           text::unsigned_zero(axis.max));
    }
    return {};
}

std::optional<Error> MachineSpace::find_axis_range_error(AxisValues axes,
                                                         const std::optional<Vector>& origin_mm) const {
    const AxisValues at_home = home();
    for (std::size_t i = 0; i < linear_.size(); ++i) {
        const auto axis = static_cast<Eigen::Index>(linear_[i]);
        axes[axis] = origin_mm ? axes[axis] + (*origin_mm)[i] : at_home[axis];
    }
    return find_axis_range_error(axes);
}

std::optional<Error> MachineSpace::find_axis_range_error(const std::map<char, double>& axes) const {
    AxisValues values = home();
    for (const auto& [letter, value] : axes) {
        if (const auto axis = machine_->find(letter)) values[static_cast<Eigen::Index>(*axis)] = value;
    }
    return find_axis_range_error(values);
}

std::optional<double> MachineSpace::max_z_mm() const {
    const double max_z_mm = machine_->axes[linear_[2]].max;
    return std::isfinite(max_z_mm) ? std::optional(max_z_mm) : std::nullopt;
}

}  // namespace gsim::path
