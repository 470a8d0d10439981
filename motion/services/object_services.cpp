#include "motion/services/object_services.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/kinematics/pose.h"

namespace gsim::motion {

using rrs::Status;

void ObjectServices::restart() {
    object_ = ObjectMotion();
    object_frame_.reset();
    object_idle_s_ = 0;
}

PlanResult ObjectServices::select_object(std::string_view frame_name) {
    CellFrames& cell = *frames_.cell();
    planner_.dwells().plan_to_standstill(true);
    if (PlanResult enabled = cell.enable_frame_motion(frame_name); !enabled) return enabled;
    object_frame_ = frame_name;
    object_idle_s_ = planner_.time_s();
    object_.set_position(cell.frame(frame_name, planner_.time_s()).value());
    return {};
}

PlanResult ObjectServices::set_object_initial_position(const rrs::CartPos& pose) {
    if (auto checked = kinematics::check_pose(pose); !checked)
        return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    if (object_frame_) {
        if (PlanResult moved = frames_.modify_cell_frame(*object_frame_, pose); !moved) return moved;
        object_idle_s_ = planner_.time_s();
    }
    object_.set_position(pose);
    return {};
}

PlanResult ObjectServices::set_object_speed(double speed_mm_s) {
    if (PlanResult checked = check_positive(speed_mm_s, "the speed of the object"); !checked) return checked;
    if (!std::isfinite(speed_mm_s))
        return make_plan_error(Status::RRS_INVALID_PARAMETER, "The object's speed is not finite.");
    object_.set_speed(speed_mm_s);
    return {};
}

PlanResult ObjectServices::set_object_next_target(const rrs::CartPos& pose) {
    if (auto checked = kinematics::check_pose(pose); !checked)
        return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    auto duration_s = object_.add_target(pose);
    if (!duration_s) return tl::unexpected(std::move(duration_s.error()));
    move_object(pose, *duration_s);
    return {};
}

Status ObjectServices::get_next_object_step(rrs::CartPos& pose, double& elapsed_s) {
    const ObjectMotion::Step step = object_.step(selections_.interpolation_s);
    pose = step.pose;
    elapsed_s = step.elapsed_s;
    return step.status;
}

/// The object begins at the program's current time, or once its targets so far are reached.
void ObjectServices::move_object(const rrs::CartPos& pose, double duration_s) {
    if (!object_frame_) return;
    planner_.dwells().plan_to_standstill(true);
    const double from_s = std::max(planner_.time_s(), object_idle_s_);
    object_idle_s_ = from_s + duration_s;
    frames_.cell()->interpolate_frame(*object_frame_, pose, from_s, object_idle_s_);
}

}  // namespace gsim::motion
