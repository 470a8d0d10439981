#include "motion/moves/conveyors.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kTravelTolerance_mm = 1e-6;

PlanResult no_such_conveyor(int conveyor) {
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           fmt::format("Conveyor {} is not defined; call DefineConveyor first.", conveyor));
}

}  // namespace

PlanResult Conveyors::define(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s) {
    if (tracked_frame_.is_of(conveyor))
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "A conveyor cannot change while it is tracked.");
    const double length = direction.norm();
    if (!std::isfinite(speed_mm_s) || !std::isfinite(length) || !(length > 0)) {
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "A conveyor must have a direction other than 0 and a finite speed.");
    }
    const double now_s = timeline_.time_s();
    const auto found = conveyors_.find(conveyor);
    const double position_mm = found == conveyors_.end() ? 0 : found->second.position_mm_at(now_s);
    conveyors_[conveyor] = {direction / length, speed_mm_s, position_mm, now_s};
    return {};
}

PlanResult Conveyors::set_position(int conveyor, double position_mm) {
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    if (!std::isfinite(position_mm))
        return make_plan_error(Status::RRS_INVALID_PARAMETER, "The position of the conveyor is not finite.");
    const double now_s = timeline_.time_s();
    if (tracked_frame_.is_of(conveyor)) {
        const double current_mm = found->second.position_mm_at(now_s);
        if (std::abs(position_mm - current_mm) <= kTravelTolerance_mm) return {};
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The conveyor is being tracked and is at {} mm; it cannot jump to {} mm.", current_mm,
                        position_mm));
    }
    found->second.position_mm = position_mm;
    found->second.at_s = now_s;
    return {};
}

PlanResult Conveyors::select_tracking(int conveyor, bool on, const Eigen::Matrix3d& base) {
    if (PlanResult ready = motion_stop_.check_ready_for_move(); !ready) return ready;
    if (PlanResult free_slots = timeline_.reserve(1); !free_slots) return free_slots;
    const auto found = conveyors_.find(conveyor);
    if (found == conveyors_.end()) return no_such_conveyor(conveyor);
    if (tracked_frame_.is_of(conveyor) == on) return {};
    return on ? start_tracking(conveyor, found->second, base) : stop_tracking();
}

PlanResult Conveyors::start_tracking(int conveyor, ConveyorMotion motion, const Eigen::Matrix3d& base) {
    const PlannerSetup& setup = machine_.setup();
    if (setup.move_limits)
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "A conveyor cannot be tracked while torques limit the accelerations.");
    if (tracked_frame_.is_active())
        return make_plan_error(Status::RRS_INVALID_PARAMETER,
                               "Another conveyor is being tracked; only one is possible at a time.");
    buffered_moves_.leave();
    if (timeline_.has_independent_motion(timeline_.time_s()))
        return make_plan_error(Status::RRS_MODE_NOT_SUPPORTED,
                               "A conveyor cannot be tracked while axes move independently.");
    motion.direction = base.transpose() * motion.direction;
    auto frame = ConveyorFrame::of(setup, machine_.axis_space(), motion);
    if (!frame) return tl::unexpected(std::move(frame.error()));
    Segment& segment = timeline_.begin_reserved(kNoTarget);
    segment.start = position_.joints();
    if (PlanResult ramp = frame->plan_ramp(setup, true, segment); !ramp) return ramp;
    const rrs::JointPos end = segment.end;
    timeline_.finish();
    position_.move_to(end - frame->shift(timeline_.time_s()));
    tracked_frame_.enter(conveyor, *std::move(frame));
    return {};
}

PlanResult Conveyors::stop_tracking() {
    const rrs::JointPos start = position_.joints() + tracked_frame_.shift_at_end();
    Segment& segment = timeline_.begin_reserved(kNoTarget);
    segment.start = start;
    if (PlanResult ramp = tracked_frame_.frame().plan_ramp(machine_.setup(), false, segment); !ramp)
        return ramp;
    position_.move_to(segment.end);
    timeline_.finish();
    tracked_frame_.leave();
    return {};
}

}  // namespace gsim::motion
