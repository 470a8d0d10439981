// The controller's services beside the moves of a program: both select modes of the one controller.

#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr std::string_view kServiceMotion =
    "the script moves by services of the controller (SetNextTarget and its kin), which tell no path; use "
    "words "
    "such as G1, or move";

}  // namespace

/// Each side has its own modes: what moves of the program have selected since is taken back.
rrs::Shell& Simulator::controller() {
    if (rapid_ >= 0) {
        leave_exact_stop();
        shell_.SetRapid(service_modes_.rapid);
        shell_.SelectTargetType(service_modes_.target_type);
        shell_.SelectMotionType(service_modes_.motion_type);
        shell_.SetCartesianOrientationSpeed(service_modes_.orientation_speed_rad_s);
        if (service_modes_.position_speed_mm_s > 0) {
            shell_.SetCartesianPositionSpeed(service_modes_.position_speed_mm_s);
        } else {
            motion_->forget_position_speed();
        }
    }
    rapid_ = -1;
    return shell_;
}

Status Simulator::set_start(const std::function<Status()>& set) {
    if (time_s() > 0) return Status::RRS_INVALID_PARAMETER;
    const Status status = set();
    position_ = position_at(motion_->position());
    return status;
}

Status Simulator::queue_target(MoveKind kind, const Place& place,
                               const std::function<Status(rrs::TargetId)>& queue) {
    const MoveInfo info = next_move(kind, place, 0);
    recorder_.expect(info);
    const Status status = queue(info.target_id);
    position_ = position_at(motion_->position());
    if (observer_ != nullptr) observer_->untold_motion(kServiceMotion);
    return status;
}

Status Simulator::cancel_motion() {
    const Status status = controller().CancelMotion();
    if (status == Status::RRS_SUCCESS) position_ = position_at(motion_->position());
    if (observer_ != nullptr) observer_->untold_motion(kServiceMotion);
    return status;
}

}  // namespace gsim::simulation
