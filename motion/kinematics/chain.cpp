#include "motion/kinematics/chain.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace gsim::kinematics {

namespace {

// Rotations of table rows are mostly multiples of 90 degrees; without rounding they give clean coordinates.
double round_if_near(double value) {
    const double nearest = std::round(value);
    return std::abs(value - nearest) < 1e-15 ? nearest : value;
}

Eigen::Matrix3d rotation(double angle_rad, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix().unaryExpr(&round_if_near);
}

rrs::CartPos dh_transform(const DhLink& row) {
    const Eigen::Matrix3d turn = rotation(row.theta_rad, Eigen::Vector3d::UnitZ());
    rrs::CartPos link = rrs::CartPos::Identity();
    link.translation() = Eigen::Vector3d(0, 0, row.d_mm) + turn * Eigen::Vector3d(row.a_mm, 0, 0);
    link.linear() = turn * rotation(row.alpha_rad, Eigen::Vector3d::UnitX());
    return link;
}

void apply_joint(rrs::CartPos& frame, rrs::JointKind kind, double value) {
    if (kind == rrs::JointKind::prismatic) {
        frame.translation() += value * frame.linear().col(2);
    } else {
        frame.linear() =
            frame.linear() * Eigen::AngleAxisd(value, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    }
}

rrs::CartPos branch_end_pose(const Branch& branch, const rrs::JointPos& joints) {
    rrs::CartPos frame = branch.base;
    for (const Link& link : branch.links) {
        if (!link.row) frame = frame * link.before;
        apply_joint(frame, link.kind, joints[link.joint]);
        frame = frame * link.after;
    }
    return frame * branch.end;
}

std::vector<rrs::CartPos> branch_frames(const Branch& branch, const rrs::JointPos& joints) {
    std::vector<rrs::CartPos> frames;
    frames.reserve(branch.links.size() + 2);
    frames.push_back(branch.base);
    for (const Link& link : branch.links) {
        rrs::CartPos frame = frames.back() * link.before;
        apply_joint(frame, link.kind, joints[link.joint]);
        frames.push_back(frame * link.after);
    }
    frames.push_back(frames.back() * branch.end);
    return frames;
}

void add_joint_frames(const Branch& branch, const rrs::JointPos& joints, std::vector<rrs::CartPos>& frames) {
    rrs::CartPos frame = branch.base;
    for (const Link& link : branch.links) {
        frame = frame * link.before;
        frames[static_cast<std::size_t>(link.joint)] = frame;
        apply_joint(frame, link.kind, joints[link.joint]);
        frame = frame * link.after;
    }
}

}  // namespace

// Rz(theta + q) Tz(d) = Rz(q) Rz(theta) Tz(d), and Tz(d + q) likewise: the motion comes before the row.
Link make_link(int joint, const DhLink& row) {
    return {.joint = joint,
            .kind = row.kind,
            .before = rrs::CartPos::Identity(),
            .after = dh_transform(row),
            .row = row};
}

Chain::Chain(Branch tool_side, Branch work_side, std::vector<int> idle_joints)
    : tool_side_(std::move(tool_side)),
      work_side_(std::move(work_side)),
      idle_joints_(std::move(idle_joints)) {
    const std::size_t count = tool_side_.links.size() + work_side_.links.size() + idle_joints_.size();
    if (count > static_cast<std::size_t>(rrs::kMaxJoints))
        throw std::invalid_argument("a kinematic chain has more joints than a JointPos can contain");
    kinds_.resize(count);
    std::vector<bool> seen(count);
    const auto add = [&](int joint, rrs::JointKind kind) {
        const auto index = static_cast<std::size_t>(joint);
        if (index >= count || seen[index])
            throw std::invalid_argument("the joints of a kinematic chain must be numbered from 0 up");
        seen[index] = true;
        kinds_[index] = kind;
    };
    for (const Branch* branch : {&tool_side_, &work_side_}) {
        for (const Link& link : branch->links) add(link.joint, link.kind);
    }
    for (const int joint : idle_joints_) add(joint, rrs::JointKind::prismatic);
    work_is_world_ = work_side_.links.empty() && (work_side_.base * work_side_.end).matrix().isIdentity(0);
}

rrs::CartPos Chain::forward(const rrs::JointPos& joints) const {
    if (work_is_world_) return branch_end_pose(tool_side_, joints);
    return branch_end_pose(work_side_, joints).inverse() * branch_end_pose(tool_side_, joints);
}

std::vector<rrs::CartPos> Chain::tool_frames(const rrs::JointPos& joints) const {
    return branch_frames(tool_side_, joints);
}

std::vector<rrs::CartPos> Chain::work_frames(const rrs::JointPos& joints) const {
    return branch_frames(work_side_, joints);
}

std::vector<rrs::CartPos> Chain::joint_frames(const rrs::JointPos& joints) const {
    std::vector<rrs::CartPos> frames(kinds_.size(), rrs::CartPos::Identity());
    add_joint_frames(tool_side_, joints, frames);
    add_joint_frames(work_side_, joints, frames);
    return frames;
}

Chain moved(const Chain& chain, const rrs::CartPos& shift) {
    Branch tool_side = chain.tool_side();
    tool_side.base = shift * tool_side.base;
    Branch work_side = chain.work_side();
    if (!work_side.links.empty()) work_side.base = shift * work_side.base;
    return Chain(std::move(tool_side), std::move(work_side), chain.idle_joints());
}

}  // namespace gsim::kinematics
