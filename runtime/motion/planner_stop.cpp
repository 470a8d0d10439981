// The services of DefaultPlanner that stop a motion, and its events.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "runtime/motion/planner.h"

namespace gsim::motion {

using rrs::Status;

namespace {

/// What each joint has both for speeding up and for slowing down.
rrs::JointPos accelerations(const PlannerSetup& setup) {
    rrs::JointPos accelerations(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        accelerations[joint] = setup.joints[static_cast<std::size_t>(joint)].least_acceleration();
    return accelerations;
}

}  // namespace

Status DefaultPlanner::StopMotion() {
    if (!initialized_) return not_initialized();
    if (tracked_ || step_s_ < conveyor_until_s_)
        return refuse(Status::RRS_MODE_NOT_SUPPORTED, "Motion along a conveyor cannot be stopped.");
    if (step_s_ < machine_moved_s_) {
        return refuse(
            Status::RRS_MODE_NOT_SUPPORTED,
            "The frame 'tool' or 'base' has been changed behind the motion under way, which cannot be "
            "stopped.");
    }
    if (!has_position_) return refuse(Status::RRS_NO_INITIAL_POSITION, "There is no motion to stop yet.");
    if (stopped_) return Status::RRS_SUCCESS;
    keeps_all_ = true;
    come_to_rest();
    keeps_all_ = false;
    stopped_ = Stopped{{}, position_};
    if (queue_.empty()) return Status::RRS_SUCCESS;
    std::vector<Segment> planned;
    for (; !queue_.empty(); queue_.pop()) planned.push_back(queue_.front());
    StoppedMotion motion = stop_motion(std::move(planned), step_s_, accelerations(machine_));
    stopped_ = Stopped{std::move(motion.rest), motion.position};
    end_s_ = step_s_;
    for (std::vector<Segment>* part : {&motion.done, &motion.braking}) {
        for (Segment& segment : *part) {
            queue_.next() = std::move(segment);
            append(queue_.next());
        }
    }
    while (!queue_.empty() && queue_.front().end_s() <= step_s_) emit_front();
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::ContinueMotion() {
    if (!initialized_) return not_initialized();
    if (!stopped_) return refuse(Status::RRS_INVALID_PARAMETER, "No motion is stopped that could go on.");
    go_on();
    return Status::RRS_SUCCESS;
}

// What `put` plans stays in the queue, whole, until it is known where it ends.
Status DefaultPlanner::put_until(const std::function<Status()>& put, const StopSearch& search) {
    if (tracked_) return refuse(Status::RRS_MODE_NOT_SUPPORTED, "Motion along a conveyor cannot be stopped.");
    flush();
    keeps_all_ = true;
    const Status status = put();
    end_model();
    keeps_all_ = false;
    std::optional<double> stop_s;
    for (std::size_t i = 0; i < queue_.size() && !stop_s; ++i) stop_s = search(queue_[i]);
    Status stopped = Status::RRS_SUCCESS;
    if (stop_s) {
        step_s_ = std::max(step_s_, *stop_s);
        stopped = StopMotion();
        if (stopped == Status::RRS_SUCCESS) stopped = CancelMotion();
    }
    flush();
    return stopped == Status::RRS_SUCCESS ? status : stopped;
}

void DefaultPlanner::go_on() {
    std::vector<Segment> rest = std::move(stopped_->rest);
    stopped_.reset();
    for (Segment& segment : restart_motion(std::move(rest), accelerations(machine_))) {
        segment.start_s = end_s_;
        queue_.next() = std::move(segment);
        append(queue_.next());
    }
}

Status DefaultPlanner::CancelMotion() {
    if (!initialized_) return not_initialized();
    if (!stopped_)
        return refuse(Status::RRS_INVALID_PARAMETER, "No motion is stopped that could be dropped.");
    position_ = stopped_->position;
    stopped_.reset();
    frames_before_.clear();
    via_.reset();
    if (model_) model_->clear();
    if (ways_ != nullptr) ways_->forget();
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::DefineEvent(int event_id, rrs::TargetId target, double offset_s) {
    return define_event(event_id, target, {EventOffset::Measure::time_s, offset_s});
}

Status DefaultPlanner::DefinePathEvent(int event_id, rrs::TargetId target, double offset_mm) {
    return define_event(event_id, target, {EventOffset::Measure::way_mm, offset_mm});
}

Status DefaultPlanner::define_event(int event_id, rrs::TargetId target, EventOffset offset) {
    if (!initialized_) return not_initialized();
    if (!std::isfinite(offset.value)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The offset of event {} is not finite.", event_id));
    }
    events_.define(event_id, target, offset);
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::CancelEvent(int event_id) {
    if (!initialized_) return not_initialized();
    if (events_.cancel(event_id)) return Status::RRS_SUCCESS;
    return refuse(Status::RRS_INVALID_PARAMETER,
                  fmt::format("There is no event {} that has yet to come true.", event_id));
}

Status DefaultPlanner::GetEvent(int number, int& event_id, double& time_s) {
    if (!initialized_) return not_initialized();
    const std::vector<EventList::CameTrue>& events = events_.came_true();
    if (number < 0 || static_cast<std::size_t>(number) >= events.size()) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no event {}; {} came true in the last step.", number, events.size()));
    }
    event_id = events[static_cast<std::size_t>(number)].id;
    time_s = events[static_cast<std::size_t>(number)].time_s;
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::motion
