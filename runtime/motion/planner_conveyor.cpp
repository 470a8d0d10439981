// The services of DefaultPlanner for conveyors, and for the object of the cell.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runtime/kinematics/pose.h"
#include "runtime/motion/planner.h"
#include "runtime/motion/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kSameTravel_mm = 1e-6;

}  // namespace

Status DefaultPlanner::no_such_conveyor(int conveyor) {
    return refuse(Status::RRS_INVALID_PARAMETER,
                  fmt::format("There is no conveyor {}; DefineConveyor comes first.", conveyor));
}

Status DefaultPlanner::DefineConveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) {
    if (!initialized_) return not_initialized();
    if (tracked_ && tracked_->conveyor == conveyor)
        return refuse(Status::RRS_INVALID_PARAMETER, "A conveyor cannot change while it is tracked.");
    const double length = direction.norm();
    if (!std::isfinite(speed_mm_s) || !std::isfinite(length) || !(length > 0)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      "A conveyor has a direction other than 0 and a finite speed.");
    }
    const auto found = conveyors_.find(conveyor);
    const double position_mm = found == conveyors_.end() ? 0 : found->second.position_mm_at(end_s_);
    conveyors_[conveyor] = {direction / length, speed_mm_s, position_mm, end_s_};
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetConveyorPosition(int conveyor, double position_mm) {
    if (!initialized_) return not_initialized();
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    if (!std::isfinite(position_mm))
        return refuse(Status::RRS_INVALID_PARAMETER, "The position of the conveyor is not finite.");
    if (tracked_ && tracked_->conveyor == conveyor) {
        const double is_mm = found->second.position_mm_at(end_s_);
        if (std::abs(position_mm - is_mm) <= kSameTravel_mm) return Status::RRS_SUCCESS;
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The conveyor is tracked and is at {} mm; it cannot jump to {} mm.", is_mm,
                                  position_mm));
    }
    found->second.position_mm = position_mm;
    found->second.at_s = end_s_;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectTracking(int conveyor, bool on) {
    if (Planned ready = ready_for_target(); !ready) return tell(std::move(ready.error()));
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    const bool tracks_it = tracked_ && tracked_->conveyor == conveyor;
    if (tracks_it == on) return Status::RRS_SUCCESS;
    if (!on) return stop_tracking();
    if (tracked_)
        return refuse(Status::RRS_INVALID_PARAMETER, "Another conveyor is tracked; one is at a time.");
    come_to_rest();
    position_ = standing();
    if (model_) model_->clear();
    ConveyorMotion conveyor_motion = found->second;
    if (cell_ != nullptr) {
        conveyor_motion.direction = cell_->base_shift().linear().transpose() * conveyor_motion.direction;
    }
    auto frame = ConveyorFrame::of(setup_, axis_space_ ? &*axis_space_ : nullptr, conveyor_motion);
    if (!frame) return tell(std::move(frame.error()));
    Segment& segment = begin_segment(queue_.next(), kNoTarget);
    if (Planned ramp = frame->plan_ramp(setup_, true, segment); !ramp) return tell(std::move(ramp.error()));
    position_ = segment.end;
    append(segment);
    position_ -= frame->shift(end_s_);
    tracked_.emplace(Tracked{conveyor, *std::move(frame), setup_});
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::stop_tracking() {
    const rrs::JointPos here = position_ + tracked_->frame.shift(end_s_);
    Segment& segment = begin_segment(queue_.next(), kNoTarget);
    segment.start = here;
    if (Planned ramp = tracked_->frame.plan_ramp(setup_, false, segment); !ramp)
        return tell(std::move(ramp.error()));
    tracked_.reset();
    position_ = segment.end;
    append(segment);
    conveyor_until_s_ = end_s_;
    return Status::RRS_SUCCESS;
}

/// The machine as a motion along the conveyor, or else any, may use it.
const PlannerSetup& DefaultPlanner::setup_for_motion() {
    if (!tracked_) return setup_;
    tracked_->setup = tracked_->frame.setup_within(setup_);
    return tracked_->setup;
}

/// A segment in the frame of the conveyor becomes one of the machine.
Planned DefaultPlanner::carry(Segment& segment) const {
    if (!tracked_) return {};
    tracked_->frame.carry(segment);
    return check_way_ranges(setup_, segment);
}

rrs::JointPos DefaultPlanner::position_at_end() const {
    return tracked_ ? rrs::JointPos(position_ + tracked_->frame.shift(end_s_)) : standing();
}

Status DefaultPlanner::SetObjectInitialPosition(const rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked)
        return refuse(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    if (object_frame_) {
        const Status moved = ModifyCellFrame(*object_frame_, pose);
        if (moved != Status::RRS_SUCCESS) return moved;
        object_free_s_ = end_s_;
    }
    object_.stand_at(pose);
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetObjectSpeed(double speed_mm_s) {
    if (!initialized_) return not_initialized();
    double speed = 0;
    const Status status = set_positive(speed, speed_mm_s, "the object's speed");
    if (status != Status::RRS_SUCCESS) return status;
    if (!std::isfinite(speed))
        return refuse(Status::RRS_INVALID_PARAMETER, "The object's speed is not finite.");
    object_.set_speed(speed);
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetObjectNextTarget(rrs::TargetId, const rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked)
        return refuse(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    auto duration_s = object_.add_target(pose);
    if (!duration_s) return tell(std::move(duration_s.error()));
    lead_object(pose, *duration_s);
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::GetNextObjectStep(rrs::CartPos& pose, double& elapsed_s) {
    if (!initialized_) return not_initialized();
    const ObjectMotion::Step step = object_.step(programmed_.interpolation_s);
    pose = step.pose;
    elapsed_s = step.elapsed_s;
    return step.status;
}

}  // namespace gsim::motion
