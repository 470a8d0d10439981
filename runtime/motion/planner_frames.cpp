// The services of DefaultPlanner for the frames of a cell.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "runtime/motion/planner.h"

namespace gsim::motion {

using rrs::Status;

Status DefaultPlanner::GetCellFrame(std::string_view frame_name, rrs::CartPos& frame) {
    if (cell_ == nullptr) return Shell::GetCellFrame(frame_name, frame);
    if (!initialized_) return not_initialized();
    auto found = cell_->frame(frame_name, end_s_);
    if (!found) return tell(std::move(found.error()));
    frame = *found;
    return Status::RRS_SUCCESS;
}

/// What was queued before is made, and told, with the frame as it was.
Status DefaultPlanner::ModifyCellFrame(std::string_view frame_name, const rrs::CartPos& frame) {
    if (cell_ == nullptr) return Shell::ModifyCellFrame(frame_name, frame);
    if (!initialized_) return not_initialized();
    const bool of_machine = MachineFrames::has(frame_name);
    if (of_machine && (tracked_ || stopped_)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The frame '{}' is the machine's, which cannot change while {}.",
                                  frame_name, tracked_ ? "a conveyor is tracked" : "a motion is stopped"));
    }
    come_to_rest(true);
    if (Planned moved = cell_->move_frame(frame_name, frame, end_s_); !moved)
        return tell(std::move(moved.error()));
    keep_frames();
    if (of_machine) machine_moved_s_ = end_s_;
    if (Planned selected = select_frames(); !selected) return tell(std::move(selected.error()));
    return Status::RRS_SUCCESS;
}

/// Those of what waits in the queue: when it is stepped through, it is told as it was planned.
void DefaultPlanner::keep_frames() {
    while (!frames_before_.empty() && frames_before_.front().until_s <= step_s_) frames_before_.pop_front();
    const bool kept = !frames_before_.empty() && frames_before_.back().until_s >= end_s_;
    if (step_s_ < end_s_ && !kept) frames_before_.push_back({end_s_, work_frames_});
}

/// The frames that are selected, as they are now.
Planned DefaultPlanner::select_frames() {
    auto frames = selected_ ? cell_->work_frames(selected_->tool, selected_->object)
                            : cell_->work_frames(kToolFrame, "work");
    if (!frames) return tl::unexpected(std::move(frames.error()));
    work_frames_ = *frames;
    tip_turns_ = tip_turns(setup_, work_frames_.tip_mm());
    return {};
}

/// Those in which the step that began at `from_s` is told.
const WorkFrames& DefaultPlanner::frames_of_step(double from_s) {
    const auto is_over = [&](const FramesUntil& before) {
        return before.until_s <= from_s || before.until_s < step_s_;
    };
    while (!frames_before_.empty() && is_over(frames_before_.front())) frames_before_.pop_front();
    return frames_before_.empty() ? work_frames_ : frames_before_.front().frames;
}

Status DefaultPlanner::SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) {
    if (cell_ == nullptr) return Shell::SelectWorkFrames(tool_frame, object_frame);
    if (!initialized_) return not_initialized();
    auto before =
        std::exchange(selected_, SelectedFrames{std::string(tool_frame), std::string(object_frame)});
    if (Planned selected = select_frames(); !selected) {
        selected_ = std::move(before);
        return tell(std::move(selected.error()));
    }
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectObject(std::string_view frame_name) {
    if (cell_ == nullptr) return Shell::SelectObject(frame_name);
    if (!initialized_) return not_initialized();
    come_to_rest(true);
    if (Planned carried = cell_->carry_frame(frame_name); !carried) return tell(std::move(carried.error()));
    object_frame_ = frame_name;
    object_free_s_ = end_s_;
    object_.stand_at(cell_->frame(frame_name, end_s_).value());
    return Status::RRS_SUCCESS;
}

/// The object begins where the program stands, or behind its targets so far.
void DefaultPlanner::lead_object(const rrs::CartPos& pose, double duration_s) {
    if (!object_frame_) return;
    come_to_rest(true);
    const double from_s = std::max(end_s_, object_free_s_);
    object_free_s_ = from_s + duration_s;
    cell_->lead_frame(*object_frame_, pose, from_s, object_free_s_);
}

/// The point that goes the programmed way, in the frame of the tool centre point.
Eigen::Vector3d DefaultPlanner::tip_mm() const {
    const bool by_pose = programmed_.target_type == rrs::TargetType::cartesian && selected_;
    return tip_ && !by_pose ? *tip_ : work_frames_.tip_mm();
}

}  // namespace gsim::motion
