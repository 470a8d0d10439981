// The services of PlannerShell for the frames of a cell, and for the object that is moved in it.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/kinematics/pose.h"
#include "motion/services/planner_shell.h"

namespace gsim::motion {

using rrs::Status;

Status PlannerShell::GetCellFrame(std::string_view frame_name, rrs::CartPos& frame) {
    if (cell_ == nullptr) return Shell::GetCellFrame(frame_name, frame);
    if (!initialized_) return not_initialized();
    auto found = cell_->frame(frame_name, planner_.time_s());
    if (!found) return to_status(std::move(found.error()));
    frame = *found;
    return Status::RRS_SUCCESS;
}

/// Motion that was queued before is made, and reported, with the old frame.
Status PlannerShell::ModifyCellFrame(std::string_view frame_name, const rrs::CartPos& frame) {
    if (cell_ == nullptr) return Shell::ModifyCellFrame(frame_name, frame);
    if (!initialized_) return not_initialized();
    const bool is_machine_frame = MachineFrames::has(frame_name);
    if (is_machine_frame && (planner_.is_tracking() || planner_.is_stopped())) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The frame '{}' is the machine's, which cannot change while {}.", frame_name,
                        planner_.is_tracking() ? "a conveyor is tracked" : "a motion is stopped"));
    }
    planner_.plan_to_standstill(true);
    if (PlanResult moved = cell_->move_frame(frame_name, frame, planner_.time_s()); !moved)
        return to_status(std::move(moved.error()));
    store_frames();
    if (is_machine_frame) machine_moved_s_ = planner_.time_s();
    if (PlanResult selected = select_frames(); !selected) return to_status(std::move(selected.error()));
    return Status::RRS_SUCCESS;
}

/// Keeps the frames of motion that waits in the queue: its steps are reported as they were planned.
void PlannerShell::store_frames() {
    while (!frames_before_.empty() && frames_before_.front().until_s <= planner_.step_time_s())
        frames_before_.pop_front();
    const bool kept = !frames_before_.empty() && frames_before_.back().until_s >= planner_.time_s();
    if (planner_.step_time_s() < planner_.time_s() && !kept)
        frames_before_.push_back({planner_.time_s(), selections_.frames});
}

/// Selects the frames again, with their current values.
PlanResult PlannerShell::select_frames() {
    const auto& names = selections_.frame_names;
    auto frames =
        names ? cell_->work_frames(names->tool, names->object) : cell_->work_frames(kToolFrame, "work");
    if (!frames) return tl::unexpected(std::move(frames.error()));
    selections_.frames = *frames;
    return {};
}

/// Returns the frames in which the step that began at `from_s` is reported.
const WorkFrames& PlannerShell::frames_of_step(double from_s) {
    const auto is_over = [&](const FramesUntil& before) {
        return before.until_s <= from_s || before.until_s < planner_.step_time_s();
    };
    while (!frames_before_.empty() && is_over(frames_before_.front())) frames_before_.pop_front();
    return frames_before_.empty() ? selections_.frames : frames_before_.front().frames;
}

Status PlannerShell::SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) {
    if (cell_ == nullptr) return Shell::SelectWorkFrames(tool_frame, object_frame);
    if (!initialized_) return not_initialized();
    auto before = std::exchange(selections_.frame_names,
                                FrameNames{std::string(tool_frame), std::string(object_frame)});
    if (PlanResult selected = select_frames(); !selected) {
        selections_.frame_names = std::move(before);
        return to_status(std::move(selected.error()));
    }
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SelectObject(std::string_view frame_name) {
    if (cell_ == nullptr) return Shell::SelectObject(frame_name);
    if (!initialized_) return not_initialized();
    planner_.plan_to_standstill(true);
    if (PlanResult enabled = cell_->enable_frame_motion(frame_name); !enabled)
        return to_status(std::move(enabled.error()));
    object_frame_ = frame_name;
    object_idle_s_ = planner_.time_s();
    object_.set_position(cell_->frame(frame_name, planner_.time_s()).value());
    return Status::RRS_SUCCESS;
}

/// The object begins at the program's current time, or after its targets so far.
void PlannerShell::move_object(const rrs::CartPos& pose, double duration_s) {
    if (!object_frame_) return;
    planner_.plan_to_standstill(true);
    const double from_s = std::max(planner_.time_s(), object_idle_s_);
    object_idle_s_ = from_s + duration_s;
    cell_->interpolate_frame(*object_frame_, pose, from_s, object_idle_s_);
}

Status PlannerShell::SetObjectInitialPosition(const rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked)
        return reject(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    if (object_frame_) {
        const Status moved = ModifyCellFrame(*object_frame_, pose);
        if (moved != Status::RRS_SUCCESS) return moved;
        object_idle_s_ = planner_.time_s();
    }
    object_.set_position(pose);
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetObjectSpeed(double speed_mm_s) {
    if (!initialized_) return not_initialized();
    double speed = 0;
    const Status status = set_positive(speed, speed_mm_s, "the object's speed");
    if (status != Status::RRS_SUCCESS) return status;
    if (!std::isfinite(speed))
        return reject(Status::RRS_INVALID_PARAMETER, "The object's speed is not finite.");
    object_.set_speed(speed);
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetObjectNextTarget(rrs::TargetId, const rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked)
        return reject(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    auto duration_s = object_.add_target(pose);
    if (!duration_s) return to_status(std::move(duration_s.error()));
    move_object(pose, *duration_s);
    return Status::RRS_SUCCESS;
}

Status PlannerShell::GetNextObjectStep(rrs::CartPos& pose, double& elapsed_s) {
    if (!initialized_) return not_initialized();
    const ObjectMotion::Step step = object_.step(selections_.interpolation_s);
    pose = step.pose;
    elapsed_s = step.elapsed_s;
    return step.status;
}

}  // namespace gsim::motion
