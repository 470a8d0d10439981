// The services of DefaultPlanner for the frames of a cell.

#include <algorithm>
#include <utility>

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

/// What was queued before is made with the frame as it was.
Status DefaultPlanner::ModifyCellFrame(std::string_view frame_name, const rrs::CartPos& frame) {
    if (cell_ == nullptr) return Shell::ModifyCellFrame(frame_name, frame);
    if (!initialized_) return not_initialized();
    come_to_rest(true);
    if (Planned moved = cell_->move_frame(frame_name, frame, end_s_); !moved)
        return tell(std::move(moved.error()));
    return selected_ ? SelectWorkFrames(selected_->tool, selected_->object) : Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) {
    if (cell_ == nullptr) return Shell::SelectWorkFrames(tool_frame, object_frame);
    if (!initialized_) return not_initialized();
    auto frames = cell_->work_frames(tool_frame, object_frame);
    if (!frames) return tell(std::move(frames.error()));
    work_frames_ = *frames;
    tip_turns_ = tip_turns(setup_, work_frames_.tip_mm());
    selected_ = SelectedFrames{std::string(tool_frame), std::string(object_frame)};
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
