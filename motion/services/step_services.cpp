#include "motion/services/step_services.h"

#include <fmt/format.h>

#include "motion/path/master_path.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kMinServiceTime_s = 1e-6;

Status step_status(MotionStep::End end) {
    switch (end) {
        case MotionStep::End::in_motion: return Status::RRS_SUCCESS;
        case MotionStep::End::target_reached: return Status::RRS_TARGET_REACHED;
        case MotionStep::End::at_end: break;
    }
    return Status::RRS_NEED_MORE_DATA;
}

}  // namespace

PlanResult StepServices::set_interpolation_time(double interpolation_s) {
    if (!(interpolation_s >= kMinServiceTime_s && interpolation_s <= kMaxDuration_s)) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The interpolation time must be from {} to {} s, not {}.",
                                           kMinServiceTime_s, kMaxDuration_s, interpolation_s));
    }
    selections_.interpolation_s = interpolation_s;
    return {};
}

tl::expected<Status, PlanError> StepServices::get_next_step(rrs::JointPos& joints, rrs::CartPos& pose,
                                                            double& elapsed_s) {
    if (!planner_.has_position())
        return make_plan_error(Status::RRS_NO_INITIAL_POSITION, "There is no position to step from yet.");
    const double from_s = planner_.timeline().step_time_s();
    const MotionStep step = planner_.step(selections_.interpolation_s);
    joints = step.joints;
    pose = frames_.frames_of_step(from_s).to_target(planner_.machine().setup().kinematics->forward(joints));
    elapsed_s = step.elapsed_s;
    return step_status(step.end);
}

PlanResult StepServices::stop_motion() {
    if (!planner_.tracked_frame().is_active_at_step_clock() && frames_.machine_moved_after_step_clock()) {
        return make_plan_error(
            Status::RRS_MODE_NOT_SUPPORTED,
            "The frame 'tool' or 'base' has been changed after the current motion, which cannot be stopped.");
    }
    return planner_.motion_stop().stop();
}

PlanResult StepServices::continue_motion() {
    if (!planner_.motion_stop().is_stopped())
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "No motion is stopped that could be continued.");
    planner_.motion_stop().resume();
    return {};
}

PlanResult StepServices::cancel_motion() {
    if (!planner_.motion_stop().is_stopped())
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "No motion is stopped that could be cancelled.");
    planner_.motion_stop().cancel();
    frames_.drop_queued();
    targets_.drop_via();
    return {};
}

}  // namespace gsim::motion
