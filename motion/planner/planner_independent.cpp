// Joints that move independently of the moves of Planner (independent groups of axes).

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/planner/planner.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kPositionTolerance = 1e-12;  // mm or rad

/// A rounded corner already consists of two simultaneous motions, and only one can be superimposed on the
/// program's.
bool rounds_corners(const rrs::ControllerRules& controller) {
    return controller.planner == rrs::PlannerKind::linuxcnc || is_blend(controller.corner) ||
           is_blend(controller.exact_path_corner);
}

}  // namespace

bool Planner::has_independent_motion(double time_s) const {
    return independent_motion_ && independent_motion_->end_s() > time_s;
}

PlanResult Planner::enqueue_independent(const rrs::JointPos& end) {
    if (PlanResult ready = check_ready_for_move(); !ready) return ready;
    if (tracking_)
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "No axes go by themselves while a conveyor is tracked.");
    if (rounds_corners(setup_.controller)) {
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "No axes go by themselves under a controller that rounds corners.");
    }
    if (PlanResult checked = check_joints(end); !checked) return checked;
    if (PlanResult checked = check_target_ranges(setup_, end); !checked) return checked;
    leave_model();
    plan_to_standstill(true);
    if (has_independent_motion(end_s_))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Other axes that go by themselves are under way.");
    auto motion = IndependentMotion::plan(setup_, position_, end, end_s_);
    if (!motion) return tl::unexpected(std::move(motion.error()));
    independent_motion_ = *std::move(motion);
    position_ = end;
    return {};
}

/// Rejects a move of a joint that currently moves independently.
PlanResult Planner::check_independent(const Move& move) const {
    if (!has_independent_motion(end_s_)) return {};
    bool leads = move.goal.pose && !has_fixed_joints();
    for (int joint = 0; joint < setup_.joint_count(); ++joint) {
        if (!independent_motion_->moves(joint)) continue;
        leads = leads || (!move.goal.pose && joint < move.goal.joints.size() &&
                          std::abs(move.goal.joints[joint] - position_[joint]) > kPositionTolerance);
    }
    if (move.goal.pose) {
        const auto is_moving = [this](const GroupJoint& one) {
            return independent_motion_->moves(one.joint);
        };
        leads = leads || std::any_of(move.goal.pose->group_joints.begin(), move.goal.pose->group_joints.end(),
                                     is_moving);
    }
    if (!leads) return {};
    return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                           "The move leads an axis that is under way by itself.");
}

}  // namespace gsim::motion
