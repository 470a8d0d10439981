// The services of PlannerShell that stop a motion, its events and its conveyors.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/services/planner_shell.h"

namespace gsim::motion {

using rrs::Status;

Status PlannerShell::StopMotion() {
    if (!initialized_) return not_initialized();
    if (!planner_.steps_along_conveyor() && planner_.step_time_s() < machine_moved_s_) {
        return reject(
            Status::RRS_MODE_NOT_SUPPORTED,
            "The frame 'tool' or 'base' has been changed behind the motion under way, which cannot be "
            "stopped.");
    }
    return to_status(planner_.stop());
}

Status PlannerShell::ContinueMotion() {
    if (!initialized_) return not_initialized();
    if (!planner_.is_stopped())
        return reject(Status::RRS_INVALID_PARAMETER, "No motion is stopped that could go on.");
    planner_.resume();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::CancelMotion() {
    if (!initialized_) return not_initialized();
    if (!planner_.is_stopped())
        return reject(Status::RRS_INVALID_PARAMETER, "No motion is stopped that could be dropped.");
    planner_.cancel();
    frames_before_.clear();
    via_.reset();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::DefineEvent(int event_id, rrs::TargetId target, double offset_s) {
    return define_event(event_id, target, {EventOffset::Measure::time_s, offset_s});
}

Status PlannerShell::DefinePathEvent(int event_id, rrs::TargetId target, double offset_mm) {
    return define_event(event_id, target, {EventOffset::Measure::distance_mm, offset_mm});
}

Status PlannerShell::define_event(int event_id, rrs::TargetId target, EventOffset offset) {
    if (!initialized_) return not_initialized();
    if (!std::isfinite(offset.value)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The offset of event {} is not finite.", event_id));
    }
    planner_.define_event(event_id, target, offset);
    return Status::RRS_SUCCESS;
}

Status PlannerShell::CancelEvent(int event_id) {
    if (!initialized_) return not_initialized();
    if (planner_.cancel_event(event_id)) return Status::RRS_SUCCESS;
    return reject(Status::RRS_INVALID_PARAMETER,
                  fmt::format("There is no event {} that has yet to come true.", event_id));
}

Status PlannerShell::GetEvent(int number, int& event_id, double& time_s) {
    if (!initialized_) return not_initialized();
    const std::vector<EventList::TriggeredEvent>& events = planner_.events_of_last_step();
    if (number < 0 || static_cast<std::size_t>(number) >= events.size()) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no event {}; {} came true in the last step.", number, events.size()));
    }
    event_id = events[static_cast<std::size_t>(number)].id;
    time_s = events[static_cast<std::size_t>(number)].time_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::DefineConveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) {
    if (!initialized_) return not_initialized();
    return to_status(planner_.define_conveyor(conveyor, direction, speed_mm_s));
}

Status PlannerShell::SetConveyorPosition(int conveyor, double position_mm) {
    if (!initialized_) return not_initialized();
    return to_status(planner_.set_conveyor_position(conveyor, position_mm));
}

Status PlannerShell::SelectTracking(int conveyor, bool on) {
    if (!initialized_) return not_initialized();
    const Eigen::Matrix3d base =
        cell_ == nullptr ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : cell_->base_shift().linear();
    return to_status(planner_.select_tracking(conveyor, on, base));
}

}  // namespace gsim::motion
