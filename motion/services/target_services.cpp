#include "motion/services/target_services.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/path/axis_space.h"
#include "motion/path/master_path.h"

namespace gsim::motion {

using rrs::Status;

PlanResult TargetServices::select_target_type(rrs::TargetType type) {
    if (type != rrs::TargetType::cartesian && type != rrs::TargetType::joint) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid target type {}; 0 is Cartesian, 1 joint.", static_cast<int>(type)));
    }
    selections_.target_type = type;
    if (type == rrs::TargetType::joint && !planner_.machine().setup().has_position_joints())
        selections_.motion_type = rrs::MotionType::joint;
    return {};
}

PlanResult TargetServices::select_motion_type(rrs::MotionType type) {
    const bool path = type == rrs::MotionType::linear || type == rrs::MotionType::circular;
    if (!path && type != rrs::MotionType::joint) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid motion type {}; 1 is joint, 2 linear, 4 circular.", static_cast<int>(type)));
    }
    if (path && !can_follow_paths()) {
        return make_plan_error(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Linear and circular motion to joint values need joints that carry the position of the tool; "
            "this machine has none.");
    }
    selections_.motion_type = type;
    drop_via();
    return {};
}

/// True if the machine can do linear and circular motion to targets of the selected type.
bool TargetServices::can_follow_paths() const {
    const PlannerSetup& setup = planner_.machine().setup();
    const bool targets_poses = selections_.target_type == rrs::TargetType::cartesian;
    return setup.has_position_joints() ||
           (targets_poses && rotary_joints_move_tcp(setup, selections_.frames.tcp_mm()));
}

PlanResult TargetServices::set_tcp_control(bool on, const Eigen::Vector3d& tcp_mm) {
    if (!tcp_mm.allFinite())
        return make_plan_error(Status::RRS_INVALID_PARAMETER, "The position of the TCP is not finite.");
    if (!on) {
        selections_.tcp_mm.reset();
        return {};
    }
    if (PlanResult checked = planner_.machine().check_tcp_control(); !checked) return checked;
    selections_.tcp_mm = tcp_mm;
    return {};
}

PlanResult TargetServices::set_motion_time(double motion_s) {
    if (PlanResult checked = check_motion_time(motion_s); !checked) return checked;
    selections_.move_parameters.motion_time_s = motion_s;
    return {};
}

PlanResult TargetServices::set_dwell(double dwell_s) {
    if (!(dwell_s >= 0 && dwell_s <= kMaxDuration_s)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("A dwell must be from 0 to {} s, not {}.", kMaxDuration_s, dwell_s));
    }
    selections_.dwell_s = dwell_s;
    return {};
}

PlanResult TargetServices::set_initial_position(const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (planner_.tracked_frame().is_active())
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "The position cannot be set while a conveyor is tracked.");
    if (PlanResult set = planner_.set_position(goal(cartesian, joints)); !set) return set;
    drop_via();
    return {};
}

PlanResult TargetServices::set_next_target(rrs::TargetId id, rrs::TargetParam param,
                                           const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                           double param_value) {
    if (PlanResult ready = planner_.motion_stop().check_ready_for_move(); !ready) return ready;
    if (!std::isfinite(param_value))
        return make_plan_error(Status::RRS_INVALID_PARAMETER, "The target's parameter is not finite.");
    if (param == rrs::TargetParam::via) return store_via(goal(cartesian, joints));
    if (param != rrs::TargetParam::end) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "A target must be the end of a motion or a via point.");
    }
    Move move = move_to(id, selections_.motion_type, goal(cartesian, joints));
    if (move.type == rrs::MotionType::circular && via_) move.via = Goal{*via_, std::nullopt};
    return enqueue(move);
}

PlanResult TargetServices::set_next_arc_target(rrs::TargetId id, const Circle& circle,
                                               const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    Move move = move_to(id, rrs::MotionType::circular, goal(cartesian, joints));
    move.circle = circle;
    if (move.goal.pose) {
        move.circle->center_mm = selections_.frames.object * circle.center_mm;
        move.circle->axis = selections_.frames.object.linear() * circle.axis;
    }
    return enqueue(move);
}

PlanResult TargetServices::plan_to_standstill(rrs::RestReason reason) {
    const int number = static_cast<int>(reason);
    if (number < 0 || number > 2) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("Invalid reason {} for a standstill; 0 is a query, 1 a wait, 2 the end.", number));
    }
    if (reason == rrs::RestReason::end) {
        planner_.dwells().plan_to_final_standstill();
    } else {
        planner_.dwells().plan_to_standstill(reason == rrs::RestReason::wait);
    }
    return {};
}

/// Returns a target by the selected type.
Goal TargetServices::goal(const rrs::CartPos& cartesian, const rrs::JointPos& joints) const {
    if (selections_.target_type == rrs::TargetType::joint) return {joints, std::nullopt};
    return {{}, PoseGoal{selections_.frames.object * cartesian, selections_.frames.tool}};
}

Move TargetServices::move_to(rrs::TargetId id, rrs::MotionType type, Goal goal) const {
    Move move;
    move.target_id = id;
    move.type = type;
    move.goal = std::move(goal);
    move.move_parameters = selections_.move_parameters;
    move.dwell_s = selections_.dwell_s;
    if (type == rrs::MotionType::joint || !selections_.tcp_mm) return move;
    const bool uses_frame_names = move.goal.pose && selections_.frame_names;
    move.tcp_mm =
        uses_frame_names ? Eigen::Vector3d(move.goal.pose->tool.translation()) : *selections_.tcp_mm;
    return move;
}

PlanResult TargetServices::enqueue(const Move& move) {
    const EnqueueResult result = planner_.enqueue(move);
    if (!result) return tl::unexpected(result.error());
    // A time, a dwell and a via point belong to one target in RRS; all other selections stay.
    selections_.move_parameters.motion_time_s = 0;
    selections_.dwell_s = 0;
    drop_via();
    if (!*result) return {};
    return tl::unexpected(motion_time_raised_error(**result));
}

PlanResult TargetServices::store_via(const Goal& goal) {
    if (selections_.motion_type != rrs::MotionType::circular) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "A via point needs circular motion; select that motion type first.");
    }
    // The via point is solved now, because the end of the path so far decides which of several solutions is
    // meant.
    rrs::JointPos via;
    if (PlanResult solved = planner_.targets().solve(goal, via); !solved) return solved;
    via_ = via;
    return {};
}

}  // namespace gsim::motion
