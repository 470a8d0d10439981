#include "runtime/kinematics/dh_chain.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace gsim::kinematics {

namespace {

// Rotations of table rows are mostly multiples of 90 degrees; cleared of rounding they give clean
// coordinates.
double without_rounding(double value) {
    const double nearest = std::round(value);
    return std::abs(value - nearest) < 1e-15 ? nearest : value;
}

Eigen::Matrix3d rotation(double angle_rad, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix().unaryExpr(&without_rounding);
}

rrs::CartPos link_at_zero(const DhLink& row) {
    const Eigen::Matrix3d turn = rotation(row.theta_rad, Eigen::Vector3d::UnitZ());
    rrs::CartPos link = rrs::CartPos::Identity();
    link.translation() = Eigen::Vector3d(0, 0, row.d_mm) + turn * Eigen::Vector3d(row.a_mm, 0, 0);
    link.linear() = turn * rotation(row.alpha_rad, Eigen::Vector3d::UnitX());
    return link;
}

// Rz(theta + q) Tz(d) = Rz(q) Rz(theta) Tz(d), and Tz(d + q) likewise: the motion stands before the link.
void apply_joint(rrs::CartPos& frame, rrs::JointKind kind, double value) {
    if (kind == rrs::JointKind::prismatic) {
        frame.translation() += value * frame.linear().col(2);
    } else {
        frame.linear() =
            frame.linear() * Eigen::AngleAxisd(value, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    }
}

}  // namespace

DhChain::DhChain(const rrs::CartPos& base, const std::vector<DhLink>& links, const rrs::CartPos& tool)
    : base_(base), links_(links), tool_(tool) {
    if (links.size() > static_cast<std::size_t>(rrs::kMaxJoints)) {
        throw std::invalid_argument("a kinematic chain has more joints than a JointPos can hold");
    }
    joints_.reserve(links.size());
    for (const DhLink& row : links) joints_.push_back({row.kind, link_at_zero(row)});
}

rrs::CartPos DhChain::forward(const rrs::JointPos& joints) const {
    rrs::CartPos frame = base_;
    Eigen::Index index = 0;
    for (const Joint& joint : joints_) {
        apply_joint(frame, joint.kind, joints[index++]);
        frame = frame * joint.link;
    }
    return frame * tool_;
}

std::vector<rrs::CartPos> DhChain::frames(const rrs::JointPos& joints) const {
    std::vector<rrs::CartPos> frames{base_};
    frames.reserve(joints_.size() + 2);
    Eigen::Index index = 0;
    for (const Joint& joint : joints_) {
        rrs::CartPos frame = frames.back();
        apply_joint(frame, joint.kind, joints[index++]);
        frames.push_back(frame * joint.link);
    }
    frames.push_back(frames.back() * tool_);
    return frames;
}

tl::expected<rrs::JointPos, std::string> ChainKinematics::inverse(const rrs::CartPos&,
                                                                  const rrs::JointPos&) const {
    return tl::unexpected<std::string>(
        "This machine has no inverse kinematics; give the target as joint values.");
}

}  // namespace gsim::kinematics
