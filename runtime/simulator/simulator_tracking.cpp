// Moves in the frame of a conveyor.

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr int kConveyor = 1;  // defined by the program's own tracking; one at a time is tracked

}  // namespace

Status Simulator::select_tracking(int conveyor, bool on) {
    motion_->come_to_rest(false);
    const Status status = shell().SelectTracking(conveyor, on);
    if (status == Status::RRS_SUCCESS) position_ = to_axes(motion_->position());
    if (on && observer_ != nullptr)
        observer_->untold_motion("the program tracks a conveyor, which takes the tool along");
    return status;
}

bool Simulator::track(const Eigen::Vector3d& direction, double position_mm, double speed_mm_s,
                      const Place& place) {
    motion_->come_to_rest(false);
    rrs::Shell& services = shell();
    const bool done = services.DefineConveyor(kConveyor, direction, speed_mm_s) == Status::RRS_SUCCESS &&
                      services.SetConveyorPosition(kConveyor, position_mm) == Status::RRS_SUCCESS &&
                      select_tracking(kConveyor, true) == Status::RRS_SUCCESS;
    return done || refused(motion_->last_error(), place);
}

bool Simulator::untrack(const Place& place) {
    return select_tracking(kConveyor, false) == Status::RRS_SUCCESS || refused(motion_->last_error(), place);
}

}  // namespace gsim::simulation
