#include "motion/services/frame_services.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "motion/path/machine_frames.h"

namespace gsim::motion {

void FrameServices::restart() {
    frames_before_.clear();
    machine_moved_s_ = 0;
    if (cell_ != nullptr) static_cast<void>(select_frames());
}

PlanResult FrameServices::get_cell_frame(std::string_view frame_name, rrs::CartPos& frame) const {
    auto found = cell_->frame(frame_name, planner_.time_s());
    if (!found) return tl::unexpected(std::move(found.error()));
    frame = *found;
    return {};
}

/// Motion that was queued before is made, and reported, with the old frame.
PlanResult FrameServices::modify_cell_frame(std::string_view frame_name, const rrs::CartPos& frame) {
    const bool is_machine_frame = MachineFrames::has(frame_name);
    const bool is_tracking = planner_.tracked_frame().is_active();
    if (is_machine_frame && (is_tracking || planner_.motion_stop().is_stopped())) {
        return make_plan_error(
            rrs::Status::RRS_INVALID_PARAMETER,
            fmt::format("The frame '{}' belongs to the machine and cannot change while {}.", frame_name,
                        is_tracking ? "a conveyor is tracked" : "a motion is stopped"));
    }
    planner_.dwells().plan_to_standstill(true);
    if (PlanResult moved = cell_->move_frame(frame_name, frame, planner_.time_s()); !moved) return moved;
    store_frames();
    if (is_machine_frame) machine_moved_s_ = planner_.time_s();
    return select_frames();
}

PlanResult FrameServices::select_work_frames(std::string_view tool_frame, std::string_view object_frame) {
    auto before = std::exchange(selections_.frame_names,
                                FrameNames{std::string(tool_frame), std::string(object_frame)});
    PlanResult selected = select_frames();
    if (!selected) selections_.frame_names = std::move(before);
    return selected;
}

Eigen::Matrix3d FrameServices::base_rotation() const {
    if (cell_ == nullptr) return Eigen::Matrix3d::Identity();
    return cell_->base_shift().linear();
}

bool FrameServices::machine_moved_after_step_clock() const {
    return planner_.timeline().step_time_s() < machine_moved_s_;
}

const WorkFrames& FrameServices::frames_of_step(double from_s) {
    const auto is_over = [&](const FramesUntil& before) {
        return before.until_s <= from_s || before.until_s < planner_.timeline().step_time_s();
    };
    while (!frames_before_.empty() && is_over(frames_before_.front())) frames_before_.pop_front();
    return frames_before_.empty() ? selections_.frames : frames_before_.front().frames;
}

/// Keeps the frames of motion that waits in the queue: its steps are reported as they were planned.
void FrameServices::store_frames() {
    const double step_s = planner_.timeline().step_time_s();
    while (!frames_before_.empty() && frames_before_.front().until_s <= step_s) frames_before_.pop_front();
    const bool kept = !frames_before_.empty() && frames_before_.back().until_s >= planner_.time_s();
    if (step_s < planner_.time_s() && !kept)
        frames_before_.push_back({planner_.time_s(), selections_.frames});
}

/// Selects the frames again, with their current values.
PlanResult FrameServices::select_frames() {
    const auto& names = selections_.frame_names;
    auto frames =
        names ? cell_->work_frames(names->tool, names->object) : cell_->work_frames(kToolFrame, "work");
    if (!frames) return tl::unexpected(std::move(frames.error()));
    selections_.frames = *frames;
    return {};
}

}  // namespace gsim::motion
