#include "runtime/simulator/controller_services.h"

#include <string_view>

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr std::string_view kServiceMotion =
    "the script moves by services of the controller (SetNextTarget and similar), which have no recordable "
    "path; use words such as G1, or move";
constexpr int kConveyor = 1;  // defined by the program's own tracking; one at a time is tracked

}  // namespace

Status ControllerServices::set_start(const std::function<Status()>& set) {
    if (clock_.time_s() > 0) return Status::RRS_INVALID_PARAMETER;
    const Status status = set();
    position_.set_joints(motion_.source().position());
    return status;
}

Status ControllerServices::queue_target(MoveKind kind, const SourceLocation& location,
                                        const std::function<Status(rrs::TargetId)>& queue) {
    const MoveInfo info = program_.make_info(kind, location, Feed{}, 0);
    motion_.source().set_enabled_overrides(info.enabled_overrides);
    motion_.recorder().expect(info);
    const Status status = queue(info.target_id);
    position_.set_joints(motion_.source().position());
    notifier_.notify_unrecordable(kServiceMotion);
    return status;
}

Status ControllerServices::cancel_motion() {
    const Status status = shell().CancelMotion();
    if (status == Status::RRS_SUCCESS) position_.set_joints(motion_.source().position());
    notifier_.notify_unrecordable(kServiceMotion);
    return status;
}

Status ControllerServices::select_tracking(int conveyor, bool on) {
    motion_.source().plan_to_standstill(false);
    const Status status = shell().SelectTracking(conveyor, on);
    if (status == Status::RRS_SUCCESS) position_.set(position_.to_axes(motion_.source().position()));
    if (on) notifier_.notify_unrecordable("the program tracks a conveyor, which moves the tool");
    return status;
}

bool ControllerServices::track(const Eigen::Vector3d& direction, double position_mm, double speed_mm_s,
                               const SourceLocation& location) {
    motion_.source().plan_to_standstill(false);
    rrs::Shell& services = shell();
    const bool done = services.DefineConveyor(kConveyor, direction, speed_mm_s) == Status::RRS_SUCCESS &&
                      services.SetConveyorPosition(kConveyor, position_mm) == Status::RRS_SUCCESS &&
                      select_tracking(kConveyor, true) == Status::RRS_SUCCESS;
    return done || outcome_.fail(motion_.source().last_error(), location);
}

bool ControllerServices::untrack(const SourceLocation& location) {
    return select_tracking(kConveyor, false) == Status::RRS_SUCCESS ||
           outcome_.fail(motion_.source().last_error(), location);
}

}  // namespace gsim::simulation
