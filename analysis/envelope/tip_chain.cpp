#include "analysis/envelope/tip_chain.h"

#include <algorithm>
#include <functional>

#include "motion/kinematics/screws.h"

namespace gsim::envelope {

namespace {

constexpr double kOnAxis_mm = 1e-7;

Eigen::Isometry3d motion(const TipJoint& joint, double value) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (joint.is_slide()) {
        pose.translation() = value * joint.direction;
    } else {
        pose.linear() = Eigen::AngleAxisd(value, joint.direction).toRotationMatrix();
        pose.translation() = joint.point_mm - pose.linear() * joint.point_mm;
    }
    return pose;
}

// Returns true if the set that joints after a revolute one make of the TCP lies on its axis: it turns
// nothing.
bool turns_nothing(const TipJoint& joint, const std::vector<TipJoint>& behind, const Vector3d& start) {
    if (joint.is_slide()) return false;
    const bool slides_along = std::all_of(behind.begin(), behind.end(), [&](const TipJoint& other) {
        return other.is_slide() && is_parallel(joint.direction, other.direction);
    });
    return slides_along && joint.direction.cross(start - joint.point_mm).norm() < kOnAxis_mm;
}

// Fixes joints at the value that `fixed_at` has for them, and moves the lines of later joints with them.
TipChain reduced(const TipChain& chain,
                 const std::function<std::optional<double>(const TipJoint&)>& fixed_at) {
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    TipChain all;
    for (TipJoint joint : chain.joints) {
        if (const auto value = fixed_at(joint)) {
            moved = moved * motion(joint, *value);
            continue;
        }
        joint.point_mm = moved * joint.point_mm;
        joint.direction = moved.linear() * joint.direction;
        all.joints.push_back(joint);
    }
    TipChain moving{{}, moved * chain.start_mm};
    for (auto joint = all.joints.rbegin(); joint != all.joints.rend(); ++joint) {
        if (!turns_nothing(*joint, moving.joints, moving.start_mm))
            moving.joints.insert(moving.joints.begin(), *joint);
    }
    return moving;
}

}  // namespace

Vector3d TipJoint::moved(const Vector3d& point, double value) const {
    if (is_slide()) return point + value * direction;
    return point_mm + Eigen::AngleAxisd(value, direction) * (point - point_mm);
}

Vector3d TipChain::tip(const std::vector<double>& values) const {
    Vector3d point = start_mm;
    for (std::size_t i = joints.size(); i > 0; --i) point = joints[i - 1].moved(point, values[i - 1]);
    return point;
}

TipChain tip_chain(const machine::Machine& machine, const machine::JointBox& box) {
    const auto kinematics = machine::make_kinematics(machine);
    const kinematics::ScrewChain screws = kinematics::screw_chain(kinematics->chain());
    const Eigen::Isometry3d to_work = screws.work_at_zero.inverse();
    TipChain chain{{}, to_work * screws.tool_at_zero.translation()};
    chain.joints.reserve(screws.screws.size());
    for (const kinematics::Screw& screw : screws.screws) {
        chain.joints.push_back({screw.joint, screw.kind, to_work * screw.point,
                                to_work.linear() * screw.direction, box.low[screw.joint],
                                box.high[screw.joint]});
    }
    return reduced(chain, [](const TipJoint& joint) -> std::optional<double> {
        if (joint.high > joint.low) return std::nullopt;
        return joint.low;
    });
}

TipChain pair_chain(const TipChain& whole, std::size_t first, std::size_t second, const rrs::JointPos& home) {
    const int kept_first = whole.joints[first].joint;
    const int kept_second = whole.joints[second].joint;
    return reduced(whole, [&](const TipJoint& joint) -> std::optional<double> {
        if (joint.joint == kept_first || joint.joint == kept_second) return std::nullopt;
        return home[joint.joint];
    });
}

bool is_parallel(const Vector3d& a, const Vector3d& b) {
    return a.cross(b).norm() < kParallel;
}

}  // namespace gsim::envelope
