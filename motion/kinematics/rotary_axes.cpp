#include "motion/kinematics/rotary_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "motion/kinematics/screws.h"

namespace gsim::kinematics {

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kAxisTolerance_rad = 1e-6;

bool parallel(const Vector3d& a, const Vector3d& b) {
    return a.cross(b).norm() < kParallel;
}

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Returns the angle of the rotation about the unit vector `axis` that aligns `from` with `to`, both projected
// along it.
double angle_about(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
    return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

}  // namespace

RotaryAxes::RotaryAxes(std::vector<Vector3d> axes, const Matrix3d& at_zero)
    : axes_(std::move(axes)), at_zero_(at_zero) {}

Matrix3d RotaryAxes::turn(int axis, double angle_rad) const {
    return AngleAxisd(angle_rad, axes_[static_cast<std::size_t>(axis)]).toRotationMatrix();
}

Matrix3d RotaryAxes::rotated(const Angles& angles) const {
    Matrix3d rotation = at_zero_;
    for (int axis = count() - 1; axis >= 0; --axis) rotation = turn(axis, angles[axis]) * rotation;
    return rotation;
}

std::vector<RotaryAxes::RotarySolution> RotaryAxes::choices(const Matrix3d& rotation,
                                                            const Angles& near) const {
    std::vector<RotarySolution> found;
    found.reserve(3);
    const Angles exact = solve_rotation(rotation * at_zero_.transpose());
    if (rotated(exact).isApprox(rotation, kAxisTolerance_rad)) found.push_back({exact, true});
    for (const Angles& angles : solve_tool_axis(rotation.col(2), near)) {
        if ((rotated(angles).col(2) - rotation.col(2)).norm() <= kAxisTolerance_rad)
            found.push_back({angles, false});
    }
    return found;
}

// Returns the angles that give `turn` = Rot(first) Rot(second), if any exist. Only the first rotation moves
// the second axis, and only the second one, undone, moves the first axis. The result is well-conditioned
// everywhere, because the axes are not parallel.
RotaryAxes::Angles RotaryAxes::solve_rotation(const Matrix3d& turn) const {
    if (axes_.empty()) return Angles::Zero();
    if (axes_.size() == 1) {
        const Vector3d perpendicular = axes_[0].unitOrthogonal();
        return {angle_about(axes_[0], perpendicular, turn * perpendicular), 0};
    }
    return {angle_about(axes_[0], axes_[1], turn * axes_[1]),
            -angle_about(axes_[1], axes_[0], turn.transpose() * axes_[0])};
}

std::vector<RotaryAxes::Angles> RotaryAxes::solve_tool_axis(const Vector3d& tool_axis,
                                                            const Angles& near) const {
    const Vector3d at_zero = at_zero_.col(2);
    if (axes_.empty()) return {Angles::Zero()};
    if (axes_.size() == 2) return solve_two_axes(tool_axis, near);
    if (parallel(at_zero, axes_[0])) return {Angles{near[0], 0}};
    return {Angles{angle_about(axes_[0], at_zero, tool_axis), 0}};
}

// Solves Rot(first) Rot(second) at_zero = tool_axis. The direction between the two rotations is on the cones
// about both axes, that is at x first + y second +- z (first x second).
std::vector<RotaryAxes::Angles> RotaryAxes::solve_two_axes(const Vector3d& tool_axis,
                                                           const Angles& near) const {
    const Vector3d& first = axes_[0];
    const Vector3d& second = axes_[1];
    const Vector3d at_zero = at_zero_.col(2);
    const double w = first.dot(second);
    const double first_component = first.dot(tool_axis);
    const double second_component = second.dot(at_zero);
    const Vector3d normal = first.cross(second);
    const double x = (first_component - w * second_component) / normal.squaredNorm();
    const double y = (second_component - w * first_component) / normal.squaredNorm();
    const double z_squared = (1 - x * x - y * y - 2 * x * y * w) / normal.squaredNorm();
    if (z_squared < -kAxisTolerance_rad) return {};
    const double z = std::sqrt(std::max(0.0, z_squared));

    std::vector<Angles> found;
    found.reserve(2);
    for (const double sign : {1.0, -1.0}) {
        const Vector3d between = x * first + y * second + sign * z * normal;
        Angles angles = near;
        if (!parallel(at_zero, second)) angles[1] = angle_about(second, at_zero, between);
        if (!parallel(tool_axis, first)) angles[0] = angle_about(first, between, tool_axis);
        found.push_back(angles);
    }
    return found;
}

// The tool axis reaches directions at certain angles to the first axis: all those between the smallest and
// the largest that the second rotation gives it.
double RotaryAxes::orientation_error_rad(const Vector3d& tool_axis) const {
    const Vector3d at_zero = at_zero_.col(2);
    if (axes_.empty()) return angle_between(at_zero, tool_axis);
    const double angle = angle_between(axes_[0], tool_axis);
    if (axes_.size() == 1) return std::abs(angle - angle_between(axes_[0], at_zero));
    const double axes_angle_rad = angle_between(axes_[0], axes_[1]);
    const double to_tool = angle_between(axes_[1], at_zero);
    const double min = std::abs(axes_angle_rad - to_tool);
    const double max = std::numbers::pi - std::abs(std::numbers::pi - axes_angle_rad - to_tool);
    return std::max({0.0, min - angle, angle - max});
}

std::string RotaryAxes::out_of_reach_message(const Vector3d& tool_axis) const {
    return fmt::format(
        "The machine's {} rotary axes cannot bring the tool into direction ({}, {}, {}); they "
        "miss "
        "it by {:.6g} deg.",
        count(), text::fixed(tool_axis.x(), 6), text::fixed(tool_axis.y(), 6), text::fixed(tool_axis.z(), 6),
        orientation_error_rad(tool_axis) * kDegPerRad);
}

}  // namespace gsim::kinematics
