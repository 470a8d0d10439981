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

Planned no_such_conveyor(int conveyor) {
    return refused(Status::RRS_INVALID_PARAMETER,
                   fmt::format("There is no conveyor {}; DefineConveyor comes first.", conveyor));
}

}  // namespace

Planned Planner::define_conveyor(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) {
    if (tracked_ && tracked_->conveyor == conveyor)
        return refused(Status::RRS_INVALID_PARAMETER, "A conveyor cannot change while it is tracked.");
    const double length = direction.norm();
    if (!std::isfinite(speed_mm_s) || !std::isfinite(length) || !(length > 0)) {
        return refused(Status::RRS_INVALID_PARAMETER,
                       "A conveyor has a direction other than 0 and a finite speed.");
    }
    const auto found = conveyors_.find(conveyor);
    const double position_mm = found == conveyors_.end() ? 0 : found->second.position_mm_at(end_s_);
    conveyors_[conveyor] = {direction / length, speed_mm_s, position_mm, end_s_};
    return {};
}

Planned Planner::set_conveyor_position(int conveyor, double position_mm) {
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    if (!std::isfinite(position_mm))
        return refused(Status::RRS_INVALID_PARAMETER, "The position of the conveyor is not finite.");
    if (tracked_ && tracked_->conveyor == conveyor) {
        const double is_mm = found->second.position_mm_at(end_s_);
        if (std::abs(position_mm - is_mm) <= kSameTravel_mm) return {};
        return refused(Status::RRS_INVALID_PARAMETER,
                       fmt::format("The conveyor is tracked and is at {} mm; it cannot jump to {} mm.", is_mm,
                                   position_mm));
    }
    found->second.position_mm = position_mm;
    found->second.at_s = end_s_;
    return {};
}

Planned Planner::select_tracking(int conveyor, bool on, const Eigen::Matrix3d& base) {
    if (Planned ready = ready_for_move(); !ready) return ready;
    if (Planned room = make_room(1); !room) return room;
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    const bool tracks_it = tracked_ && tracked_->conveyor == conveyor;
    if (tracks_it == on) return {};
    if (!on) return stop_tracking();
    if (setup_.move_limits)
        return refused(Status::RRS_MODE_NOT_SUPPORTED,
                       "No conveyor is tracked while torques limit the accelerations.");
    if (tracked_)
        return refused(Status::RRS_INVALID_PARAMETER, "Another conveyor is tracked; one is at a time.");
    leave_model();
    if (has_own_motion(end_s_))
        return refused(Status::RRS_MODE_NOT_SUPPORTED, "No conveyor is tracked while axes go by themselves.");
    ConveyorMotion conveyor_motion = found->second;
    conveyor_motion.direction = base.transpose() * conveyor_motion.direction;
    auto frame = ConveyorFrame::of(setup_, axis_space_ ? &*axis_space_ : nullptr, conveyor_motion);
    if (!frame) return tl::unexpected(std::move(frame.error()));
    Segment& segment = begin_segment(queue_.next(), kNoTarget);
    if (Planned ramp = frame->plan_ramp(setup_, true, segment); !ramp) return ramp;
    position_ = segment.end;
    append(segment);
    position_ -= frame->shift(end_s_);
    tracked_.emplace(Tracked{conveyor, *std::move(frame), setup_});
    return {};
}

Planned Planner::stop_tracking() {
    const rrs::JointPos here = position_ + tracked_->frame.shift(end_s_);
    Segment& segment = begin_segment(queue_.next(), kNoTarget);
    segment.start = here;
    if (Planned ramp = tracked_->frame.plan_ramp(setup_, false, segment); !ramp) return ramp;
    tracked_.reset();
    position_ = segment.end;
    append(segment);
    conveyor_until_s_ = end_s_;
    return {};
}

/// Returns the machine as a motion along the conveyor may use it, or else any motion.
const PlannerSetup& Planner::setup_for_motion() {
    if (!tracked_) return setup_;
    tracked_->setup = tracked_->frame.setup_within(setup_);
    return tracked_->setup;
}

/// Converts a segment in the frame of the conveyor into one of the machine.
Planned Planner::carry(Segment& segment) const {
    if (!tracked_) return {};
    tracked_->frame.carry(segment);
    return check_way_ranges(setup_, segment);
}

rrs::JointPos Planner::position_at_end() const {
    if (tracked_) return position_ + tracked_->frame.shift(end_s_);
    return own_ ? rrs::JointPos(standing() + own_->left(end_s_)) : standing();
}

}  // namespace gsim::motion
