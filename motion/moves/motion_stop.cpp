#include "motion/moves/motion_stop.h"

#include <utility>

#include "motion/planner/stop.h"

namespace gsim::motion {

using rrs::Status;

namespace {

/// Returns the acceleration that each joint has both for speeding up and for slowing down.
rrs::JointPos accelerations(const PlannerSetup& setup) {
    rrs::JointPos accelerations(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        accelerations[joint] = setup.joints[static_cast<std::size_t>(joint)].min_acceleration();
    return accelerations;
}

}  // namespace

PlanResult MotionStop::stop() {
    if (tracked_frame_.is_active_at_step_clock())
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED, "Motion along a conveyor cannot be stopped.");
    if (!position_.is_set())
        return make_plan_error(Status::RRS_NO_INITIAL_POSITION, "There is no motion to stop yet.");
    if (timeline_.has_independent_motion(timeline_.step_time_s()))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "Motion cannot be stopped while axes move independently.");
    if (stopped_) return {};
    timeline_.end_independent_motion();  // it has ended, and is in what is planned
    timeline_.keep_all_segments(true);
    buffered_moves_.plan_to_standstill();
    timeline_.keep_all_segments(false);
    stopped_ = StopState{{}, position_.joints()};
    if (timeline_.queue().empty()) return {};
    StoppedMotion motion = stop_motion(timeline_.cut_at_step_clock(), timeline_.step_time_s(),
                                       accelerations(machine_.original()));
    stopped_ = StopState{std::move(motion.remainder), motion.position};
    for (std::vector<Segment>* part : {&motion.done, &motion.braking}) {
        for (Segment& segment : *part) timeline_.append(std::move(segment));
    }
    timeline_.release_passed();
    return {};
}

void MotionStop::resume() {
    std::vector<Segment> remainder = std::move(stopped_->remainder);
    stopped_.reset();
    for (Segment& segment : restart_motion(std::move(remainder), accelerations(machine_.original()))) {
        segment.start_s = timeline_.time_s();
        timeline_.append(std::move(segment));
    }
}

void MotionStop::cancel() {
    position_.move_to(stopped_->position);
    stopped_.reset();
    buffered_moves_.drop();
}

std::optional<rrs::JointPos> MotionStop::position() const {
    if (!stopped_) return std::nullopt;
    return stopped_->position;
}

std::optional<rrs::TargetId> MotionStop::remaining_target() const {
    if (!stopped_ || stopped_->remainder.empty()) return std::nullopt;
    return stopped_->remainder.front().target_id;
}

PlanResult MotionStop::check_ready_for_move() const {
    if (!position_.is_set()) {
        return make_plan_error(
            Status::RRS_NO_INITIAL_POSITION,
            "The robot has no position yet; call SetInitialPosition before the first target.");
    }
    if (stopped_) {
        return make_plan_error(
            Status::RRS_QUEUE_FULL,
            "The motion is stopped; call ContinueMotion or CancelMotion before another target.");
    }
    return {};
}

}  // namespace gsim::motion
