#include "motion/kinematics/gantry.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/kinematics/solution.h"

namespace gsim::kinematics {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using rrs::JointKind;

constexpr double kOrthogonal = 1e-9;
constexpr double kTipTolerance_mm = 1e-6;
constexpr double kFlatTolerance =
    1e-6;  // volume spanned by three unit vectors below which they lie in a plane

RotaryAxes rotary_axes(const ScrewChain& chain) {
    std::vector<Vector3d> axes;
    for (const Screw& screw : chain.screws) {
        if (screw.kind == JointKind::revolute) axes.push_back(screw.direction);
    }
    return {std::move(axes), chain.tool_at_zero.linear()};
}

double distance_mm(const Screw& axis, const Vector3d& point) {
    return axis.direction.cross(point - axis.point).norm();
}

std::vector<int> revolute_joints(const ScrewChain& chain) {
    std::vector<int> joints;
    for (const Screw& screw : chain.screws) {
        if (screw.kind == JointKind::revolute) joints.push_back(screw.joint);
    }
    return joints;
}

}  // namespace

GantryKinematics::GantryKinematics(Chain chain, std::vector<JointRange> ranges)
    : chain_(std::move(chain)),
      ranges_(std::move(ranges)),
      screws_(screw_chain(chain_)),
      rotary_joints_(revolute_joints(screws_)),
      rotary_(rotary_axes(screws_)) {}

tl::expected<std::shared_ptr<const GantryKinematics>, std::string> GantryKinematics::make(
    Chain chain, std::vector<JointRange> ranges) {
    if (auto error = find_error(chain, ranges)) return tl::unexpected(*std::move(error));
    std::shared_ptr<GantryKinematics> gantry(new GantryKinematics(std::move(chain), std::move(ranges)));
    if (std::optional<std::string> obstacle = gantry->analyze()) return tl::unexpected(*std::move(obstacle));
    return gantry;
}

std::optional<std::string> GantryKinematics::analyze() {
    const int rotary = static_cast<int>(rotary_joints_.size());
    const int linear = chain_.joint_count() - rotary;
    if (linear != 3 || rotary > 2) {
        return fmt::format(
            "The gantry's closed-form inverse is for three linear axes and at most two rotary ones; "
            "this chain has {} linear and {} rotary joints.",
            linear, rotary);
    }
    Matrix3d slides;
    int column = 0;
    std::vector<Vector3d> axes;
    for (const Screw& screw : screws_.screws) {
        if (!screw.direction.allFinite() || !screw.point.allFinite())
            return "The kinematic chain contains a value that is not finite.";
        if (screw.kind == JointKind::prismatic) slides.col(column++) = screw.direction;
        if (screw.kind == JointKind::revolute) axes.push_back(screw.direction);
    }
    if (!screws_.tool_at_zero.matrix().allFinite() || !screws_.work_at_zero.matrix().allFinite())
        return "The kinematic chain contains a value that is not finite.";
    if (std::abs(slides.determinant()) < kFlatTolerance)
        return "The gantry's closed-form inverse needs three linear axes that do not lie in one plane.";
    if (axes.size() == 2 && axes[0].cross(axes[1]).norm() < kParallel)
        return "The gantry's closed-form inverse needs two rotary axes that are not parallel.";
    return std::nullopt;
}

tl::expected<rrs::JointPos, std::string> GantryKinematics::inverse(const rrs::CartPos& pose,
                                                                   const rrs::JointPos& near) const {
    return solutions(pose, near).map([](std::vector<rrs::JointPos> all) { return all.front(); });
}

tl::expected<std::vector<rrs::JointPos>, std::string> GantryKinematics::solutions(
    const rrs::CartPos& pose, const rrs::JointPos& near) const {
    if (auto error = find_error(chain_, pose, near)) return tl::unexpected(*std::move(error));
    RotaryAxes::Angles reference_angles = RotaryAxes::Angles::Zero();
    for (std::size_t i = 0; i < rotary_joints_.size(); ++i)
        reference_angles[static_cast<Eigen::Index>(i)] = near[rotary_joints_[i]];

    const rrs::CartPos target = screws_.work_at_zero * pose;
    const std::vector<RotaryAxes::RotarySolution> choices =
        rotary_.choices(target.linear(), reference_angles);
    if (choices.empty()) return tl::unexpected(rotary_.out_of_reach_message(target.linear().col(2)));
    std::vector<Solution> found;
    found.reserve(choices.size());
    for (const RotaryAxes::RotarySolution& choice : choices) {
        auto joints = joints_at(target, choice.angles);
        if (!joints) continue;
        unwrap_near(chain_, ranges_, near, *joints);
        found.push_back({*std::move(joints), choice.exact});
    }
    if (found.empty()) {
        return tl::unexpected<std::string>(
            "The pose is singular: at the required values of the rotary axes, the linear axes move in one "
            "plane.");
    }
    return sorted_solutions(chain_, ranges_, near, std::move(found));
}

// With the angles given, the TCP is at E(angles) tip_at_zero + sum of q_i R_i v_i: each slide's direction is
// turned by the rotary joints before it, and E is the chain without the slides.
std::optional<rrs::JointPos> GantryKinematics::joints_at(const rrs::CartPos& target,
                                                         const RotaryAxes::Angles& angles) const {
    rrs::JointPos joints(joint_count());
    std::array<int, 3> slides{};
    Matrix3d directions;
    rrs::CartPos rotated = rrs::CartPos::Identity();
    int slide = 0;
    int axis = 0;
    for (const Screw& screw : screws_.screws) {
        if (screw.kind == JointKind::prismatic) {
            directions.col(slide) = rotated.linear() * screw.direction;
            slides[static_cast<std::size_t>(slide++)] = screw.joint;
            continue;
        }
        const Matrix3d turn = rotary_.turn(axis, angles[axis]);
        rotated.translate(screw.point - turn * screw.point);
        rotated.linear() = rotated.linear() * turn;
        joints[screw.joint] = angles[axis++];
    }
    if (std::abs(directions.determinant()) < kFlatTolerance) return std::nullopt;
    const Vector3d values =
        directions.inverse() * (target.translation() - rotated * screws_.tool_at_zero.translation());
    for (int i = 0; i < 3; ++i) joints[slides[static_cast<std::size_t>(i)]] = values[i];
    return joints;
}

std::optional<TiltingHead> GantryKinematics::tilting_head() const {
    if (rotary_joints_.size() != 2) return std::nullopt;
    const Screw& turn = screws_.screws[3];
    const Screw& tilt = screws_.screws[4];
    if (turn.kind != JointKind::revolute || tilt.kind != JointKind::revolute) return std::nullopt;
    const Vector3d tcp = screws_.tool_at_zero.translation();
    const double tip_offset_mm = std::max(distance_mm(turn, tcp), distance_mm(tilt, tcp));
    const Vector3d tool = screws_.tool_at_zero.linear().col(2);
    const Vector3d& pole = turn.direction;
    const double non_orthogonality =
        std::max(std::abs(pole.dot(tilt.direction)), std::abs(tool.dot(tilt.direction)));
    if (tip_offset_mm > kTipTolerance_mm || non_orthogonality > kOrthogonal) return std::nullopt;
    return TiltingHead{turn.joint, tilt.joint,
                       std::atan2(tool.dot(tilt.direction.cross(pole)), tool.dot(pole))};
}

}  // namespace gsim::kinematics
