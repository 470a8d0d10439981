// Joints that move independently of the moves of Planner (independent groups of axes).

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/planner/planner.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kStands = 1e-12;  // mm or rad

/// A rounded corner already consists of two simultaneous motions, and only one can be superimposed on the
/// program's.
bool rounds_corners(const rrs::ControllerRules& controller) {
    return controller.planner == rrs::PlannerKind::linuxcnc || is_blend(controller.corner) ||
           is_blend(controller.exact_path_corner);
}

}  // namespace

bool Planner::has_own_motion(double time_s) const {
    return own_ && own_->end_s() > time_s;
}

Planned Planner::put_own(const rrs::JointPos& end) {
    if (Planned ready = ready_for_move(); !ready) return ready;
    if (tracked_)
        return refused(Status::RRS_MODE_NOT_SUPPORTED,
                       "No axes go by themselves while a conveyor is tracked.");
    if (rounds_corners(setup_.controller)) {
        return refused(Status::RRS_MODE_NOT_SUPPORTED,
                       "No axes go by themselves under a controller that rounds corners.");
    }
    if (Planned checked = check_joints(end); !checked) return checked;
    if (Planned checked = check_target_ranges(setup_, end); !checked) return checked;
    leave_model();
    come_to_rest(true);
    if (has_own_motion(end_s_))
        return refused(Status::RRS_MODE_NOT_SUPPORTED, "Other axes that go by themselves are under way.");
    auto motion = OwnMotion::plan(setup_, position_, end, end_s_);
    if (!motion) return tl::unexpected(std::move(motion.error()));
    own_ = *std::move(motion);
    position_ = end;
    return {};
}

/// Rejects a move of a joint that currently moves independently.
Planned Planner::check_own(const Move& move) const {
    if (!has_own_motion(end_s_)) return {};
    bool leads = move.goal.pose && !holds_joints();
    for (int joint = 0; joint < setup_.joint_count(); ++joint) {
        if (!own_->moves(joint)) continue;
        leads = leads || (!move.goal.pose && joint < move.goal.joints.size() &&
                          std::abs(move.goal.joints[joint] - position_[joint]) > kStands);
    }
    if (move.goal.pose) {
        const auto is_under_way = [this](const LedJoint& one) { return own_->moves(one.joint); };
        leads = leads || std::any_of(move.goal.pose->led.begin(), move.goal.pose->led.end(), is_under_way);
    }
    if (!leads) return {};
    return refused(Status::RRS_MODE_NOT_SUPPORTED, "The move leads an axis that is under way by itself.");
}

}  // namespace gsim::motion
