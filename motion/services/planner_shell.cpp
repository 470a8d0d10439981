#include "motion/services/planner_shell.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

PlannerShell::PlannerShell(Planner& planner) : planner_(planner) {}

Status PlannerShell::Initialize() {
    restart();
    initialized_ = true;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::Reset() {
    if (!initialized_) return not_initialized();
    restart();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::Terminate() {
    if (!initialized_) return not_initialized();
    restart();
    initialized_ = false;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::GetMessage(std::string& message) {
    message = error_.message;
    return Status::RRS_SUCCESS;
}

void PlannerShell::restart() {
    planner_.restart();
    selections_ = {};
    via_.reset();
    frames_before_.clear();
    machine_moved_s_ = 0;
    if (cell_ != nullptr) static_cast<void>(select_frames());
    object_ = ObjectMotion();
    object_frame_.reset();
    object_idle_s_ = 0;
    error_ = {};
}

/// Returns a target by the selected type.
Goal PlannerShell::goal(const rrs::CartPos& cartesian, const rrs::JointPos& joints) const {
    if (selections_.target_type == rrs::TargetType::joint) return {joints, std::nullopt};
    return {{}, PoseGoal{selections_.frames.object * cartesian, selections_.frames.tool}};
}

Move PlannerShell::move_to(rrs::TargetId id, rrs::MotionType type, Goal goal) const {
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

Status PlannerShell::enqueue(const Move& move) {
    const EnqueueResult result = planner_.enqueue(move);
    if (!result) return to_status(result.error());
    // A time, a dwell and a via point belong to one target in RRS; all other selections stay.
    selections_.move_parameters.motion_time_s = 0;
    selections_.dwell_s = 0;
    via_.reset();
    if (!*result) return Status::RRS_SUCCESS;
    return to_status(time_raised(**result));
}

Status PlannerShell::SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                        std::string_view) {
    if (!initialized_) return not_initialized();
    if (planner_.is_tracking())
        return reject(Status::RRS_INVALID_PARAMETER,
                      "The position cannot be set while a conveyor is tracked.");
    if (PlanResult is_stationary = planner_.set_position(goal(cartesian, joints)); !is_stationary)
        return to_status(std::move(is_stationary.error()));
    via_.reset();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                   const rrs::JointPos& joints, std::string_view, double param_value) {
    if (!initialized_) return not_initialized();
    if (PlanResult ready = planner_.check_ready_for_move(); !ready)
        return to_status(std::move(ready.error()));
    if (!std::isfinite(param_value))
        return reject(Status::RRS_INVALID_PARAMETER, "The target's parameter is not finite.");
    if (param == rrs::TargetParam::via) return store_via(goal(cartesian, joints));
    if (param != rrs::TargetParam::end) {
        return reject(Status::RRS_INVALID_PARAMETER, "A target is the end of a motion or a via point.");
    }
    Move move = move_to(id, selections_.motion_type, goal(cartesian, joints));
    if (move.type == rrs::MotionType::circular && via_) move.via = Goal{*via_, std::nullopt};
    return enqueue(move);
}

Status PlannerShell::SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param,
                                        const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                        std::string_view configuration, double param_value,
                                        std::string_view target_name) {
    const Status status = SetNextTarget(id, param, cartesian, joints, configuration, param_value);
    if (status != Status::RRS_SUCCESS)
        error_.message = fmt::format("Target {}: {}", target_name, error_.message);
    return status;
}

Status PlannerShell::SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                      const Eigen::Vector3d& axis, double sweep_rad,
                                      const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (!initialized_) return not_initialized();
    Move move = move_to(id, rrs::MotionType::circular, goal(cartesian, joints));
    move.circle = Circle{center_mm, axis, sweep_rad};
    if (move.goal.pose) {
        move.circle->center_mm = selections_.frames.object * center_mm;
        move.circle->axis = selections_.frames.object.linear() * axis;
    }
    return enqueue(move);
}

Status PlannerShell::store_via(const Goal& goal) {
    if (selections_.motion_type != rrs::MotionType::circular) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      "A via point belongs to circular motion; select that motion type first.");
    }
    // The via point is solved now, because the end of the path so far decides which of several solutions is
    // meant.
    rrs::JointPos via;
    if (PlanResult solved = planner_.solve(goal, via); !solved) return to_status(std::move(solved.error()));
    via_ = via;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetNextRest(rrs::TargetId id, double dwell_s) {
    if (!initialized_) return not_initialized();
    return to_status(planner_.enqueue_dwell(id, dwell_s));
}

Status PlannerShell::ComeToRest(rrs::RestReason reason) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(reason);
    if (number < 0 || number > 2) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no reason {} to come to rest; 0 is a query, 1 a wait, 2 the end.", number));
    }
    if (reason == rrs::RestReason::end) {
        planner_.plan_to_final_standstill();
    } else {
        planner_.plan_to_standstill(reason == rrs::RestReason::wait);
    }
    return Status::RRS_SUCCESS;
}

Status PlannerShell::GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) {
    if (!initialized_) return not_initialized();
    if (!planner_.has_position())
        return reject(Status::RRS_NO_INITIAL_POSITION, "There is no position to step from yet.");
    const double from_s = planner_.step_time_s();
    const Planner::Step step = planner_.step(selections_.interpolation_s);
    joints = step.joints;
    pose = frames_of_step(from_s).to_target(planner_.setup().kinematics->forward(joints));
    elapsed_s = step.elapsed_s;
    switch (step.end) {
        case Planner::Step::StepEnd::in_motion: return Status::RRS_SUCCESS;
        case Planner::Step::StepEnd::target_reached: return Status::RRS_TARGET_REACHED;
        case Planner::Step::StepEnd::at_end: break;
    }
    return Status::RRS_NEED_MORE_DATA;
}

Status PlannerShell::GetTargetOfLastStep(rrs::TargetId& id) {
    if (!initialized_) return not_initialized();
    id = planner_.target_of_last_step();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::GetCurrentTargetId(rrs::TargetId& id) {
    if (!initialized_) return not_initialized();
    id = planner_.current_target();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::to_status(PlanError error) {
    error_ = std::move(error);
    return error_.status;
}

Status PlannerShell::to_status(PlanResult planned) {
    return planned ? Status::RRS_SUCCESS : to_status(std::move(planned.error()));
}

Status PlannerShell::reject(Status status, std::string message) {
    return to_status(PlanError{.status = status, .message = std::move(message)});
}

Status PlannerShell::not_initialized() {
    return reject(Status::RRS_NOT_INITIALIZED, "The planner is not initialized; call Initialize first.");
}

Status PlannerShell::not_supported(std::string_view service) {
    return reject(Status::RRS_SERVICE_NOT_SUPPORTED,
                  fmt::format("The default planner does not offer the service {}.", service));
}

}  // namespace gsim::motion
