#include "motion/moves/target_solver.h"

#include <utility>

#include <fmt/format.h>

#include "motion/kinematics/pose.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kMaxValue = 1e12;  // mm or rad; what is computed from it stays far from overflow

}  // namespace

PlanResult TargetSolver::solve(const Goal& goal, rrs::JointPos& joints) const {
    PlanResult solved = goal.pose ? solve_pose(*goal.pose, joints) : check_joints(goal.joints);
    if (!goal.pose) joints = goal.joints;
    // In the frame of a conveyor, ranges are checked along the path.
    if (!solved || tracked_frame_.is_active()) return solved;
    return check_target_ranges(machine_.setup(), joints);
}

PlanResult TargetSolver::check_joints(const rrs::JointPos& joints) const {
    const int joint_count = machine_.setup().joint_count();
    if (joints.size() != joint_count) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The target has {} joint values; the machine has {} joints.",
                                           joints.size(), joint_count));
    }
    if (!(joints.array().abs() <= kMaxValue).all()) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The target contains a joint value that is not a number within +-{}.", kMaxValue));
    }
    return {};
}

PlanResult TargetSolver::solve_pose(const PoseGoal& goal, rrs::JointPos& joints) const {
    if (auto checked = kinematics::check_pose(goal.pose); !checked)
        return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    rrs::JointPos near = position_.joints();
    for (const GroupJoint& one : goal.group_joints) near[one.joint] = one.value;
    auto solution = machine_.setup().kinematics->inverse(goal.tcp_pose(), near);
    if (!solution) return make_plan_error(Status::RRS_NO_SOLUTION, std::move(solution.error()));
    joints = *solution;
    return check_joints(joints);
}

}  // namespace gsim::motion
