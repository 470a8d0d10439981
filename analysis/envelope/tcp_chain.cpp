#include "analysis/envelope/tcp_chain.h"

#include <algorithm>
#include <functional>

#include "motion/kinematics/screws.h"

namespace gsim::envelope {

namespace {

constexpr double kAxisTolerance_mm = 1e-7;

Eigen::Isometry3d motion(const TcpJoint& joint, double value) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (joint.is_slide()) {
        pose.translation() = value * joint.direction;
    } else {
        pose.linear() = Eigen::AngleAxisd(value, joint.direction).toRotationMatrix();
        pose.translation() = joint.point_mm - pose.linear() * joint.point_mm;
    }
    return pose;
}

// Returns true if a revolute joint turns nothing, because all TCP positions that later joints reach lie on
// its axis.
bool has_no_effect(const TcpJoint& joint, const std::vector<TcpJoint>& later_joints, const Vector3d& start) {
    if (joint.is_slide()) return false;
    const bool are_all_parallel_slides =
        std::all_of(later_joints.begin(), later_joints.end(), [&](const TcpJoint& other) {
            return other.is_slide() && is_parallel(joint.direction, other.direction);
        });
    return are_all_parallel_slides &&
           joint.direction.cross(start - joint.point_mm).norm() < kAxisTolerance_mm;
}

// Fixes joints at the value that `fixed_value` has for them, and moves the lines of later joints with them.
TcpChain fix_joints(const TcpChain& chain,
                    const std::function<std::optional<double>(const TcpJoint&)>& fixed_value) {
    Eigen::Isometry3d transformed = Eigen::Isometry3d::Identity();
    TcpChain all;
    for (TcpJoint joint : chain.joints) {
        if (const auto value = fixed_value(joint)) {
            transformed = transformed * motion(joint, *value);
            continue;
        }
        joint.point_mm = transformed * joint.point_mm;
        joint.direction = transformed.linear() * joint.direction;
        all.joints.push_back(joint);
    }
    TcpChain moving{{}, transformed * chain.start_mm};
    for (auto joint = all.joints.rbegin(); joint != all.joints.rend(); ++joint) {
        if (!has_no_effect(*joint, moving.joints, moving.start_mm))
            moving.joints.insert(moving.joints.begin(), *joint);
    }
    return moving;
}

}  // namespace

Vector3d TcpJoint::transformed(const Vector3d& point, double value) const {
    if (is_slide()) return point + value * direction;
    return point_mm + Eigen::AngleAxisd(value, direction) * (point - point_mm);
}

Vector3d TcpChain::tcp(const std::vector<double>& values) const {
    Vector3d point = start_mm;
    for (std::size_t i = joints.size(); i > 0; --i) point = joints[i - 1].transformed(point, values[i - 1]);
    return point;
}

TcpChain tcp_chain(const machine::Machine& machine, const machine::JointBox& box) {
    const auto kinematics = machine::make_kinematics(machine);
    const kinematics::ScrewChain screws = kinematics::screw_chain(kinematics->chain());
    const Eigen::Isometry3d to_work = screws.work_at_zero.inverse();
    TcpChain chain{{}, to_work * screws.tool_at_zero.translation()};
    chain.joints.reserve(screws.screws.size());
    for (const kinematics::Screw& screw : screws.screws) {
        chain.joints.push_back({screw.joint, screw.kind, to_work * screw.point,
                                to_work.linear() * screw.direction, box.low[screw.joint],
                                box.high[screw.joint]});
    }
    return fix_joints(chain, [](const TcpJoint& joint) -> std::optional<double> {
        if (joint.high > joint.low) return std::nullopt;
        return joint.low;
    });
}

TcpChain pair_chain(const TcpChain& full_chain, std::size_t first, std::size_t second,
                    const rrs::JointPos& home) {
    const int first_free_joint = full_chain.joints[first].joint;
    const int second_free_joint = full_chain.joints[second].joint;
    return fix_joints(full_chain, [&](const TcpJoint& joint) -> std::optional<double> {
        if (joint.joint == first_free_joint || joint.joint == second_free_joint) return std::nullopt;
        return home[joint.joint];
    });
}

bool is_parallel(const Vector3d& a, const Vector3d& b) {
    return a.cross(b).norm() < kParallel;
}

}  // namespace gsim::envelope
