#include "analysis/check/inverse_check.h"

#include <algorithm>

#include "motion/kinematics/chain.h"
#include "motion/kinematics/solution.h"

namespace gsim::check {

namespace {

constexpr int kClosedFormPoses = 2000;
constexpr int kNumericPoses = 100;
constexpr double kPoseTolerance = 1e-6;  // mm and rad

std::vector<kinematics::JointRange> ranges(const machine::Machine& machine) {
    std::vector<kinematics::JointRange> list;
    list.reserve(machine.axes.size());
    for (const machine::Axis& axis : machine.axes) {
        list.push_back({machine::joint_value(axis, axis.min), machine::joint_value(axis, axis.max),
                        std::string(1, axis.letter)});
    }
    return list;
}

}  // namespace

InverseCheck check_inverse(const machine::Machine& machine, const machine::JointBox& box) {
    InverseCheck check;
    const auto kinematics = machine::make_kinematics(machine);
    if (!kinematics->has_inverse()) return check;
    const rrs::JointPos home = machine::home_position(machine);
    const std::vector<kinematics::JointRange> limits = ranges(machine);
    const bool numeric = kinematics->inverse_kind() == kinematics::InverseKind::numeric;
    check.poses = numeric ? kNumericPoses : kClosedFormPoses;
    for (int number = 1; number <= check.poses; ++number) {
        const rrs::JointPos joints = box.at(machine::halton_point(number, kinematics->joint_count()));
        const rrs::CartPos pose = kinematics->forward(joints);
        rrs::JointPos near = home;
        for (const int fixed_joint : kinematics->fixed_joints()) near[fixed_joint] = joints[fixed_joint];
        const auto found = kinematics->inverse(pose, near);
        const bool was_consistent = check.is_consistent();
        if (!found) {
            if (check.unsolved++ == 0) check.message = found.error();
        } else {
            const rrs::CartPos reached_pose = kinematics->forward(*found);
            const double mm = (reached_pose.translation() - pose.translation()).norm();
            const Eigen::AngleAxisd turn(pose.linear().transpose() * reached_pose.linear());
            check.worst_mm = std::max(check.worst_mm, mm);
            check.worst_rad = std::max(check.worst_rad, std::abs(turn.angle()));
            check.inaccurate_count +=
                mm <= kPoseTolerance && std::abs(turn.angle()) <= kPoseTolerance ? 0 : 1;
            check.out_of_range += kinematics::in_range(limits, *found) ? 0 : 1;
        }
        if (was_consistent && !check.is_consistent()) check.first_bad = joints;
    }
    return check;
}

}  // namespace gsim::check
