#include "runtime/kinematics/gantry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "runtime/kinematics/pose.h"

namespace gsim::kinematics {

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using rrs::JointKind;

constexpr double kOrthogonal = 1e-9;
constexpr double kThroughTip_mm = 1e-6;
constexpr double kOrientation_rad = 1e-6;
constexpr double kParallel = 1e-9;  // sine of the angle below which two directions count as parallel

bool parallel(const Vector3d& a, const Vector3d& b) {
    return a.cross(b).norm() < kParallel;
}

// The angle of the rotation about the unit vector `axis` that brings `from` over `to`, both projected along
// it.
double angle_about(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
    return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

double with_turns_near(double angle, double near) {
    return angle + 2 * std::numbers::pi * std::round((near - angle) / (2 * std::numbers::pi));
}

Eigen::Vector2d with_turns_near(const Eigen::Vector2d& angles, const Eigen::Vector2d& near) {
    return {with_turns_near(angles[0], near[0]), with_turns_near(angles[1], near[1])};
}

Matrix3d rotation(double angle, const Vector3d& axis) {
    return AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

tl::expected<std::shared_ptr<const GantryKinematics>, std::string> GantryKinematics::make(DhChain chain) {
    std::shared_ptr<GantryKinematics> gantry(new GantryKinematics(std::move(chain)));
    if (std::optional<std::string> obstacle = gantry->study()) return tl::unexpected(*std::move(obstacle));
    return gantry;
}

std::optional<std::string> GantryKinematics::study() {
    const int count = chain_.joint_count();
    if (count < 3 || count > 5) {
        return fmt::format(
            "The gantry's closed-form inverse is for three linear axes and at most two rotary ones; "
            "this chain has {} joints.",
            count);
    }
    for (int joint = 0; joint < count; ++joint) {
        const JointKind wanted = joint < 3 ? JointKind::prismatic : JointKind::revolute;
        if (chain_.kind(joint) == wanted) continue;
        return fmt::format(
            "The gantry's closed-form inverse needs the chain to begin with three linear axes, rotary ones "
            "behind them; joint {} (counted from 0) is {}.",
            joint, wanted == JointKind::prismatic ? "rotary" : "linear");
    }
    rotary_count_ = count - 3;
    const std::vector<rrs::CartPos> at_zero = chain_.frames(rrs::JointPos::Zero(count));
    if (!at_zero.back().matrix().allFinite()) return "The kinematic chain holds a value that is not finite.";
    tip_at_zero_ = at_zero.back().translation();
    rotation_at_zero_ = at_zero.back().linear();
    if (auto obstacle = study_linear_axes(at_zero)) return obstacle;
    return study_rotary_axes(at_zero);
}

std::optional<std::string> GantryKinematics::study_linear_axes(const std::vector<rrs::CartPos>& at_zero) {
    for (int joint = 0; joint < 3; ++joint) {
        linear_axes_.col(joint) = at_zero[static_cast<std::size_t>(joint)].linear().col(2);
    }
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const double cosine = linear_axes_.col(a).dot(linear_axes_.col(b));
        if (std::abs(cosine) < kOrthogonal) continue;
        return fmt::format(
            "The gantry's closed-form inverse needs linear axes at right angles; those of joints {} and {} "
            "(counted from 0) stand at {:.6f} deg.",
            a, b, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
    }
    return std::nullopt;
}

std::optional<std::string> GantryKinematics::study_rotary_axes(const std::vector<rrs::CartPos>& at_zero) {
    for (int joint = 3; joint < 3 + rotary_count_; ++joint) {
        const rrs::CartPos& frame = at_zero[static_cast<std::size_t>(joint)];
        const Vector3d axis = frame.linear().col(2);
        const double offset_mm = axis.cross(tip_at_zero_ - frame.translation()).norm();
        if (offset_mm > kThroughTip_mm) {
            return fmt::format(
                "The gantry's closed-form inverse needs rotary axes through the tool tip; that of joint {} "
                "(counted from 0) passes it at {:.6f} mm.",
                joint, offset_mm);
        }
        (joint == 3 ? first_axis_ : second_axis_) = axis;
    }
    if (rotary_count_ == 2 && parallel(first_axis_, second_axis_)) {
        return "The gantry's closed-form inverse needs two rotary axes that are not parallel.";
    }
    return std::nullopt;
}

tl::expected<rrs::JointPos, std::string> GantryKinematics::inverse(const rrs::CartPos& pose,
                                                                   const rrs::JointPos& near) const {
    if (auto valid = check_pose(pose); !valid) return tl::unexpected(valid.error());
    if (near.size() != joint_count() || !near.allFinite()) {
        return tl::unexpected(
            fmt::format("The joint values near the solution must be {} finite numbers.", joint_count()));
    }
    Angles near_angles = Angles::Zero();
    near_angles.head(rotary_count_) = near.tail(rotary_count_);

    Angles angles = exact_angles(pose.linear() * rotation_at_zero_.transpose());
    if (!turned(angles).isApprox(pose.linear(), kOrientation_rad)) {
        const auto matching = tool_axis_angles(pose.linear().col(2), near_angles);
        if (!matching) {
            return tl::unexpected<std::string>(fmt::format(
                "The machine's {} rotary axes cannot bring the tool into direction ({:.6f}, {:.6f}, {:.6f}).",
                rotary_count_, pose(0, 2), pose(1, 2), pose(2, 2)));
        }
        angles = *matching;
    }
    rrs::JointPos joints(joint_count());
    joints.head<3>() = linear_axes_.transpose() * (pose.translation() - tip_at_zero_);
    joints.tail(rotary_count_) = with_turns_near(angles, near_angles).head(rotary_count_);
    return joints;
}

std::optional<TiltingHead> GantryKinematics::tilting_head() const {
    const Vector3d tool = rotation_at_zero_.col(2);
    const double off_square =
        std::max(std::abs(first_axis_.dot(second_axis_)), std::abs(tool.dot(second_axis_)));
    if (rotary_count_ != 2 || off_square > kOrthogonal) return std::nullopt;
    return TiltingHead{3, 4, std::atan2(tool.dot(second_axis_.cross(first_axis_)), tool.dot(first_axis_))};
}

Matrix3d GantryKinematics::turned(const Angles& angles) const {
    return rotation(angles[0], first_axis_) * rotation(angles[1], second_axis_) * rotation_at_zero_;
}

// The angles that give `turn` = Rot(first) Rot(second), if any do: the first rotation alone moves the second
// axis, and the second alone, undone, the first axis. Well-conditioned everywhere, as the axes are not
// parallel.
GantryKinematics::Angles GantryKinematics::exact_angles(const Matrix3d& turn) const {
    if (rotary_count_ == 0) return Angles::Zero();
    if (rotary_count_ == 1) {
        const Vector3d across = first_axis_.unitOrthogonal();
        return {angle_about(first_axis_, across, turn * across), 0};
    }
    return {angle_about(first_axis_, second_axis_, turn * second_axis_),
            -angle_about(second_axis_, first_axis_, turn.transpose() * first_axis_)};
}

std::optional<GantryKinematics::Angles> GantryKinematics::tool_axis_angles(const Vector3d& tool_axis,
                                                                           const Angles& near) const {
    auto angles = rotary_count_ == 2 ? two_axis_angles(tool_axis, near) : one_axis_angles(tool_axis, near);
    if (!angles || (turned(*angles).col(2) - tool_axis).norm() > kOrientation_rad) return std::nullopt;
    return angles;
}

std::optional<GantryKinematics::Angles> GantryKinematics::one_axis_angles(const Vector3d& tool_axis,
                                                                          const Angles& near) const {
    const Vector3d at_zero = rotation_at_zero_.col(2);
    if (rotary_count_ == 0 || parallel(at_zero, first_axis_)) return near;
    return Angles{angle_about(first_axis_, at_zero, tool_axis), near[1]};
}

// Rot(first) Rot(second) at_zero = tool_axis: the direction between the two rotations lies on the cones about
// both axes, that is at x first + y second +- z (first x second).
std::optional<GantryKinematics::Angles> GantryKinematics::two_axis_angles(const Vector3d& tool_axis,
                                                                          const Angles& near) const {
    const Vector3d at_zero = rotation_at_zero_.col(2);
    const double w = first_axis_.dot(second_axis_);
    const double along_first = first_axis_.dot(tool_axis);
    const double along_second = second_axis_.dot(at_zero);
    const Vector3d normal = first_axis_.cross(second_axis_);
    const double x = (along_first - w * along_second) / normal.squaredNorm();
    const double y = (along_second - w * along_first) / normal.squaredNorm();
    const double z_squared = (1 - x * x - y * y - 2 * x * y * w) / normal.squaredNorm();
    if (z_squared < -kOrientation_rad) return std::nullopt;
    const double z = std::sqrt(std::max(0.0, z_squared));

    std::optional<Angles> best;
    for (const double sign : {1.0, -1.0}) {
        const Vector3d between = x * first_axis_ + y * second_axis_ + sign * z * normal;
        Angles angles{near[0], angle_about(second_axis_, at_zero, between)};
        if (!parallel(tool_axis, first_axis_)) angles[0] = angle_about(first_axis_, between, tool_axis);
        angles = with_turns_near(angles, near);
        if (!best || (angles - near).squaredNorm() < (*best - near).squaredNorm()) best = angles;
    }
    return best;
}

}  // namespace gsim::kinematics
