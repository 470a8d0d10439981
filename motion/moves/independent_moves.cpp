#include "motion/moves/independent_moves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kPositionTolerance = 1e-12;  // mm or rad

/// A rounded corner already consists of two simultaneous motions, and only one can be superimposed on the
/// program's.
bool rounds_corners(const rrs::ControllerRules& controller) {
    return controller.capabilities().blends_at_tolerance || is_blend(controller.corners.continuous) ||
           is_blend(controller.corners.exact_path);
}

}  // namespace

IndependentMoves::IndependentMoves(const ActiveMachine& machine, const TrackedFrame& tracked_frame,
                                   const MotionStop& motion_stop, const TargetSolver& targets,
                                   BufferedMoves& buffered_moves, Dwells& dwells, Timeline& timeline,
                                   RobotPosition& position)
    : machine_(machine),
      tracked_frame_(tracked_frame),
      motion_stop_(motion_stop),
      targets_(targets),
      buffered_moves_(buffered_moves),
      dwells_(dwells),
      timeline_(timeline),
      position_(position) {}

PlanResult IndependentMoves::enqueue(const rrs::JointPos& end) {
    if (PlanResult ready = motion_stop_.check_ready_for_move(); !ready) return ready;
    if (tracked_frame_.is_active())
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Axes cannot move independently while a conveyor is tracked.");
    const PlannerSetup& setup = machine_.setup();
    if (rounds_corners(setup.controller)) {
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Axes cannot move independently with a controller that rounds corners.");
    }
    if (PlanResult checked = targets_.check_joints(end); !checked) return checked;
    if (PlanResult checked = check_target_ranges(setup, end); !checked) return checked;
    buffered_moves_.leave();
    dwells_.plan_to_standstill(true);
    if (timeline_.has_independent_motion(timeline_.time_s()))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Other axes are already moving independently.");
    auto motion = IndependentMotion::plan(setup, position_.joints(), end, timeline_.time_s());
    if (!motion) return tl::unexpected(std::move(motion.error()));
    timeline_.superimpose(*std::move(motion));
    position_.move_to(end);
    return {};
}

double IndependentMoves::end_s() const {
    const auto& motion = timeline_.independent_motion();
    return motion ? motion->end_s() : 0;
}

PlanResult IndependentMoves::check(const Move& move) const {
    if (!timeline_.has_independent_motion(timeline_.time_s())) return {};
    const IndependentMotion& motion = *timeline_.independent_motion();
    bool leads = move.goal.pose && !machine_.has_fixed_joints();
    for (int joint = 0; joint < machine_.setup().joint_count(); ++joint) {
        if (!motion.moves(joint)) continue;
        leads = leads || (!move.goal.pose && joint < move.goal.joints.size() &&
                          std::abs(move.goal.joints[joint] - position_.joints()[joint]) > kPositionTolerance);
    }
    if (move.goal.pose) {
        const auto is_moving = [&motion](const GroupJoint& one) { return motion.moves(one.joint); };
        leads = leads || std::any_of(move.goal.pose->group_joints.begin(), move.goal.pose->group_joints.end(),
                                     is_moving);
    }
    if (!leads) return {};
    return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                           "The move contains an axis that is moving independently.");
}

}  // namespace gsim::motion
