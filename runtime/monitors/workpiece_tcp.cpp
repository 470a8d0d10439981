#include "runtime/monitors/workpiece_tcp.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kSlopeTolerance = 1e-9;

}  // namespace

WorkpieceTcp::WorkpieceTcp(const motion::PlannerSetup& setup, const Vector3d& tcp_mm)
    : kinematics_(setup.kinematics.get()), tcp_mm_(tcp_mm) {
    if (motion::rotary_joints_move_tcp(setup, tcp_mm)) {
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            if (setup.role(joint) == motion::JointRole::rotary) rotating_joints_.push_back(joint);
        }
    }
    set_position(rrs::JointPos::Zero(setup.joint_count()));
    if (can_rotate() || !setup.has_position_joints()) return;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) axes.col(axis) = jacobian_.col(joint);
    }
    preserves_distances_ =
        (axes.transpose() * axes).isIdentity(kSlopeTolerance) && moved_by_position_joints_only(setup);
}

/// Returns true if the joints other than X, Y and Z leave the TCP at its position.
bool WorkpieceTcp::moved_by_position_joints_only(const motion::PlannerSetup& setup) const {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (setup.role(joint) != motion::JointRole::position && !jacobian_.col(joint).isZero(kSlopeTolerance))
            return false;
    }
    return true;
}

bool WorkpieceTcp::turns(const rrs::JointPos& from, const rrs::JointPos& to) const {
    return std::any_of(rotating_joints_.begin(), rotating_joints_.end(),
                       [&](int joint) { return from[joint] != to[joint]; });
}

double WorkpieceTcp::rotation_rad(const rrs::JointPos& from, const rrs::JointPos& to) const {
    double rotation_rad = 0;
    for (const int joint : rotating_joints_) rotation_rad += std::abs(to[joint] - from[joint]);
    return rotation_rad;
}

void WorkpieceTcp::set_position(const rrs::JointPos& joints) {
    if (linearized_at_.size() > 0 && !turns(linearized_at_, joints)) return;
    linearized_at_ = joints;
    jacobian_.setZero(3, joints.size());
    const Vector3d current = kinematics_->forward(joints) * tcp_mm_;
    for (Eigen::Index joint = 0; joint < joints.size(); ++joint) {
        rrs::JointPos moved = joints;
        moved[joint] += 1;
        const bool rotates_tcp = std::find(rotating_joints_.begin(), rotating_joints_.end(),
                                           static_cast<int>(joint)) != rotating_joints_.end();
        if (!rotates_tcp) jacobian_.col(joint) = kinematics_->forward(moved) * tcp_mm_ - current;
    }
    origin_mm_ = current - jacobian_ * joints;
}

Vector3d WorkpieceTcp::at(const rrs::JointPos& joints) const {
    if (turns(linearized_at_, joints)) return kinematics_->forward(joints) * tcp_mm_;
    Vector3d tcp_mm = origin_mm_;
    for (Eigen::Index joint = 0; joint < joints.size(); ++joint)
        tcp_mm += joints[joint] * jacobian_.col(joint);
    return tcp_mm;
}

}  // namespace gsim::simulation
