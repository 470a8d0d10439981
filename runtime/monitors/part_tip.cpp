#include "runtime/monitors/part_tip.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kNoSlope = 1e-9;

}  // namespace

PartTip::PartTip(const motion::PlannerSetup& setup, const Vector3d& tip_mm)
    : kinematics_(setup.kinematics.get()), tip_mm_(tip_mm) {
    if (motion::tip_turns(setup, tip_mm)) {
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            if (setup.role(joint) == motion::JointRole::rotary) turning_.push_back(joint);
        }
    }
    stand_at(rrs::JointPos::Zero(setup.joint_count()));
    if (ever_turns() || !setup.has_position_joints()) return;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) axes.col(axis) = slopes_.col(joint);
    }
    keeps_distances_ = (axes.transpose() * axes).isIdentity(kNoSlope) && moved_by_position_alone(setup);
}

/// Returns true if the joints other than X, Y and Z leave the TCP at its position.
bool PartTip::moved_by_position_alone(const motion::PlannerSetup& setup) const {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (setup.role(joint) != motion::JointRole::position && !slopes_.col(joint).isZero(kNoSlope))
            return false;
    }
    return true;
}

bool PartTip::turns(const rrs::JointPos& from, const rrs::JointPos& to) const {
    return std::any_of(turning_.begin(), turning_.end(), [&](int joint) { return from[joint] != to[joint]; });
}

double PartTip::turned_rad(const rrs::JointPos& from, const rrs::JointPos& to) const {
    double turned_rad = 0;
    for (const int joint : turning_) turned_rad += std::abs(to[joint] - from[joint]);
    return turned_rad;
}

void PartTip::stand_at(const rrs::JointPos& joints) {
    if (standing_.size() > 0 && !turns(standing_, joints)) return;
    standing_ = joints;
    slopes_.setZero(3, joints.size());
    const Vector3d here = kinematics_->forward(joints) * tip_mm_;
    for (Eigen::Index joint = 0; joint < joints.size(); ++joint) {
        rrs::JointPos moved = joints;
        moved[joint] += 1;
        const bool turns_tip =
            std::find(turning_.begin(), turning_.end(), static_cast<int>(joint)) != turning_.end();
        if (!turns_tip) slopes_.col(joint) = kinematics_->forward(moved) * tip_mm_ - here;
    }
    origin_mm_ = here - slopes_ * joints;
}

Vector3d PartTip::at(const rrs::JointPos& joints) const {
    if (turns(standing_, joints)) return kinematics_->forward(joints) * tip_mm_;
    Vector3d tip_mm = origin_mm_;
    for (Eigen::Index joint = 0; joint < joints.size(); ++joint) tip_mm += joints[joint] * slopes_.col(joint);
    return tip_mm;
}

}  // namespace gsim::simulation
