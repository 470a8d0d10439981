// Planner's conveyors.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/planner/planner.h"
#include "motion/planner/range_check.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kSameTravel_mm = 1e-6;

PlanResult no_such_conveyor(int conveyor) {
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           fmt::format("There is no conveyor {}; DefineConveyor comes first.", conveyor));
}

}  // namespace

PlanResult Planner::define_conveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) {
    if (tracking_ && tracking_->conveyor == conveyor)
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "A conveyor cannot change while it is tracked.");
    const double length = direction.norm();
    if (!std::isfinite(speed_mm_s) || !std::isfinite(length) || !(length > 0)) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "A conveyor has a direction other than 0 and a finite speed.");
    }
    const auto found = conveyors_.find(conveyor);
    const double position_mm = found == conveyors_.end() ? 0 : found->second.position_mm_at(end_s_);
    conveyors_[conveyor] = {direction / length, speed_mm_s, position_mm, end_s_};
    return {};
}

PlanResult Planner::set_conveyor_position(int conveyor, double position_mm) {
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    if (!std::isfinite(position_mm))
        return make_plan_error(Status::RRS_INVALID_PARAMETER, "The position of the conveyor is not finite.");
    if (tracking_ && tracking_->conveyor == conveyor) {
        const double current_mm = found->second.position_mm_at(end_s_);
        if (std::abs(position_mm - current_mm) <= kSameTravel_mm) return {};
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The conveyor is tracked and is at {} mm; it cannot jump to {} mm.", current_mm,
                        position_mm));
    }
    found->second.position_mm = position_mm;
    found->second.at_s = end_s_;
    return {};
}

PlanResult Planner::select_tracking(int conveyor, bool on, const Eigen::Matrix3d& base) {
    if (PlanResult ready = check_ready_for_move(); !ready) return ready;
    if (PlanResult free_slots = reserve_segments(1); !free_slots) return free_slots;
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    const bool is_tracked = tracking_ && tracking_->conveyor == conveyor;
    if (is_tracked == on) return {};
    if (!on) return stop_tracking();
    if (setup_.move_limits)
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "No conveyor is tracked while torques limit the accelerations.");
    if (tracking_)
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "Another conveyor is tracked; one is at a time.");
    leave_model();
    if (has_independent_motion(end_s_))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "No conveyor is tracked while axes go by themselves.");
    ConveyorMotion conveyor_motion = found->second;
    conveyor_motion.direction = base.transpose() * conveyor_motion.direction;
    auto frame = ConveyorFrame::of(setup_, axis_space_ ? &*axis_space_ : nullptr, conveyor_motion);
    if (!frame) return tl::unexpected(std::move(frame.error()));
    Segment& segment = begin_segment(queue_.next(), kNoTarget);
    if (PlanResult ramp = frame->plan_ramp(setup_, true, segment); !ramp) return ramp;
    position_ = segment.end;
    append(segment);
    position_ -= frame->shift(end_s_);
    tracking_.emplace(Tracking{conveyor, *std::move(frame), setup_});
    return {};
}

PlanResult Planner::stop_tracking() {
    const rrs::JointPos current = position_ + tracking_->frame.shift(end_s_);
    Segment& segment = begin_segment(queue_.next(), kNoTarget);
    segment.start = current;
    if (PlanResult ramp = tracking_->frame.plan_ramp(setup_, false, segment); !ramp) return ramp;
    tracking_.reset();
    position_ = segment.end;
    append(segment);
    tracking_end_s_ = end_s_;
    return {};
}

/// Returns the machine as a motion along the conveyor may use it, or else any motion.
const PlannerSetup& Planner::setup_for_motion() {
    if (!tracking_) return setup_;
    tracking_->setup = tracking_->frame.remaining_setup(setup_);
    return tracking_->setup;
}

/// Converts a segment in the frame of the conveyor into one of the machine.
PlanResult Planner::superimpose(Segment& segment) const {
    if (!tracking_) return {};
    tracking_->frame.superimpose(segment);
    return check_path_ranges(setup_, segment);
}

rrs::JointPos Planner::position_at_end() const {
    if (tracking_) return position_ + tracking_->frame.shift(end_s_);
    return independent_motion_ ? rrs::JointPos(standstill_position() + independent_motion_->remaining(end_s_))
                               : standstill_position();
}

}  // namespace gsim::motion
