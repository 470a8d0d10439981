// Moves in the frame of a conveyor.

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr int kConveyor = 1;  // defined by the program's own tracking; one at a time is tracked

}  // namespace

Status Simulator::select_tracking(int conveyor, bool on) {
    motion_->plan_to_standstill(false);
    const Status status = shell().SelectTracking(conveyor, on);
    if (status == Status::RRS_SUCCESS) position_ = to_axes(motion_->position());
    if (on && observer_ != nullptr)
        observer_->on_unrecordable_motion("the program tracks a conveyor, which takes the tool along");
    return status;
}

bool Simulator::track(const Eigen::Vector3d& direction, double position_mm, double speed_mm_s,
                      const SourceLocation& location) {
    motion_->plan_to_standstill(false);
    rrs::Shell& services = shell();
    const bool done = services.DefineConveyor(kConveyor, direction, speed_mm_s) == Status::RRS_SUCCESS &&
                      services.SetConveyorPosition(kConveyor, position_mm) == Status::RRS_SUCCESS &&
                      select_tracking(kConveyor, true) == Status::RRS_SUCCESS;
    return done || report_plan_error(motion_->last_error(), location);
}

bool Simulator::untrack(const SourceLocation& location) {
    return select_tracking(kConveyor, false) == Status::RRS_SUCCESS ||
           report_plan_error(motion_->last_error(), location);
}

}  // namespace gsim::simulation
