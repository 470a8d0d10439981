// The services of DefaultPlanner for the frames of a cell.

#include <utility>

#include "runtime/motion/planner.h"

namespace gsim::motion {

using rrs::Status;

Status DefaultPlanner::GetCellFrame(std::string_view frame_name, rrs::CartPos& frame) {
    if (cell_ == nullptr) return Shell::GetCellFrame(frame_name, frame);
    auto found = cell_->frame(frame_name);
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

/// The point that goes the programmed way, in the frame of the tool centre point.
Eigen::Vector3d DefaultPlanner::tip_mm() const {
    const bool by_pose = programmed_.target_type == rrs::TargetType::cartesian && selected_;
    return tip_ && !by_pose ? *tip_ : work_frames_.tip_mm();
}

}  // namespace gsim::motion
