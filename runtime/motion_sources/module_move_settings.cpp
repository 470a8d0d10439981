#include "runtime/motion_sources/module_move_settings.h"

#include <cmath>
#include <cstddef>
#include <span>

namespace gsim::simulation {

using rrs::is_error_status;
using rrs::MotionType;
using rrs::Status;
using rrs::TargetType;

namespace {

/// Returns true if the service is missing, or the module is broken; any other result leaves the controller as
/// it can be.
bool is_unsupported(Status status) {
    return status == Status::RRS_SERVICE_NOT_SUPPORTED || status == Status::RRS_MODULE_FAULT;
}

std::span<const double> all_of(const rrs::JointPos& joints) {
    return {joints.data(), static_cast<std::size_t>(joints.size())};
}

}  // namespace

/// Sends the kind of the move's target and path. Poses are impossible without the services; joint values
/// continue with what the controller has.
Status ModuleMoveSettings::send_kind(const motion::Move& move) {
    ModuleModes& sent = shell_.move_modes();
    const TargetType target = move.goal.pose ? TargetType::cartesian : TargetType::joint;
    const MotionType type = move.via ? MotionType::circular : move.circle ? MotionType::linear : move.type;
    const auto is_fatal = [&](Status status) {
        return move.goal.pose ? is_error_status(status) : is_unsupported(status);
    };
    if (sent.target_type != target) {
        if (const Status status = shell_.SelectTargetType(target); is_fatal(status)) return status;
        sent.motion_type.reset();  // a module may go back to joint motion
    }
    sent.target_type = target;
    if (sent.motion_type != type) {
        const Status status = shell_.SelectMotionType(type);
        if (is_fatal(status)) return status;
        sent.joint_motion_only = status == Status::RRS_MOTION_TYPE_NOT_SUPPORTED;
    }
    sent.motion_type = type;
    if (sent.rapid == move.move_parameters.rapid) return Status::RRS_SUCCESS;
    const Status status = shell_.SetRapid(move.move_parameters.rapid);
    const bool has_no_rapid = !move.move_parameters.rapid && status == Status::RRS_SERVICE_NOT_SUPPORTED;
    if (is_unsupported(status) && !has_no_rapid) return status;
    sent.rapid = move.move_parameters.rapid;
    return Status::RRS_SUCCESS;
}

Status ModuleMoveSettings::send_feed(const motion::MoveParameters& move_parameters) {
    ModuleModes& sent = shell_.move_modes();
    const bool accepts_any_speed =
        move_parameters.rapid || move_parameters.motion_time_s > 0;  // will do: it does not hold
    const double position_mm_s = accepts_any_speed ? motion::kUnlimited : move_parameters.position_speed_mm_s;
    const double orientation_rad_s =
        accepts_any_speed ? motion::kUnlimited : move_parameters.orientation_speed_rad_s;
    if (move_parameters.rapid && sent.position_speed_mm_s) return Status::RRS_SUCCESS;
    if (sent.position_speed_mm_s != position_mm_s) {
        const Status status = shell_.SetCartesianPositionSpeed(position_mm_s);
        if (status != Status::RRS_SUCCESS && !accepts_any_speed) return status;
        sent.position_speed_mm_s = position_mm_s;
    }
    if (move_parameters.rapid) return Status::RRS_SUCCESS;
    if (sent.orientation_speed_rad_s != orientation_rad_s) {
        const Status status = shell_.SetCartesianOrientationSpeed(orientation_rad_s);
        if (status != Status::RRS_SUCCESS && !accepts_any_speed) return status;
        sent.orientation_speed_rad_s = orientation_rad_s;
    }
    return move_parameters.motion_time_s > 0 ? shell_.SetMotionTime(move_parameters.motion_time_s)
                                             : Status::RRS_SUCCESS;
}

/// Returns the speeds for a line of joint values that are independent, because none of the joints carries the
/// tool. They move evenly, all together as fast as the feed says, which is that of the slides if some move.
rrs::JointPos ModuleMoveSettings::joint_speeds(const motion::Move& move) const {
    rrs::JointPos speeds = rrs::JointPos::Constant(shell_.target().size(), motion::kUnlimited);
    if (move.move_parameters.rapid || move.move_parameters.motion_time_s > 0) return speeds;
    const rrs::JointPos displacement = (move.goal.joints - shell_.target()).cwiseAbs();
    rrs::JointPos prismatic_displacement = displacement;
    for (Eigen::Index i = 0; i < displacement.size(); ++i) {
        if (joints_[static_cast<std::size_t>(i)].kind == rrs::JointKind::revolute)
            prismatic_displacement[i] = 0;
    }
    const bool turns = prismatic_displacement.isZero(0);
    const double length = turns ? displacement.norm() : prismatic_displacement.norm();
    const double speed =
        turns ? move.move_parameters.orientation_speed_rad_s : move.move_parameters.position_speed_mm_s;
    for (Eigen::Index i = 0; i < displacement.size(); ++i) {
        if (displacement[i] > 0 && std::isfinite(speed)) speeds[i] = speed * displacement[i] / length;
    }
    return speeds;
}

Status ModuleMoveSettings::send_joint_speeds(const motion::Move& move) {
    ModuleModes& sent = shell_.move_modes();
    if (!sent.joint_motion_only || move.goal.pose) return Status::RRS_SUCCESS;
    const rrs::JointPos speeds = joint_speeds(move);
    if (sent.joint_speeds == speeds) return Status::RRS_SUCCESS;
    sent.joint_speeds = speeds;
    const Status status = shell_.SetJointSpeeds({}, all_of(speeds));
    if (status != Status::RRS_SERVICE_NOT_SUPPORTED) return status;
    warnings_.emplace_back(
        "the controller does not support joint speeds (SetJointSpeeds): joints move at its default speeds");
    return Status::RRS_SUCCESS;
}

void ModuleMoveSettings::send_blending(const motion::MoveParameters& move_parameters) {
    if (move_parameters.path_mode == sent_.path_mode && move_parameters.tolerance_mm == sent_.tolerance_mm &&
        move_parameters.merge_tolerance_mm == sent_.merge_tolerance_mm) {
        return;
    }
    sent_.path_mode = move_parameters.path_mode;
    sent_.tolerance_mm = move_parameters.tolerance_mm;
    sent_.merge_tolerance_mm = move_parameters.merge_tolerance_mm;
    if (shell_.SetPathMode(move_parameters.path_mode, move_parameters.tolerance_mm,
                           move_parameters.merge_tolerance_mm) == Status::RRS_SERVICE_NOT_SUPPORTED) {
        warnings_.emplace_back(
            "the controller does not support path modes (G61, G64): it uses its default at the ends of "
            "moves");
    }
}

void ModuleMoveSettings::send_ramps(const motion::MoveParameters& move_parameters) {
    if (move_parameters.ramps == sent_.ramps) return;
    sent_.ramps = move_parameters.ramps;
    motion::ProgrammedRamps ramps = move_parameters.ramps
                                        ? *move_parameters.ramps
                                        : motion::ProgrammedRamps(static_cast<int>(shell_.target().size()));
    const auto add_remark = [&](Status status) {
        if (is_error_status(status)) warnings_.push_back(shell_.last_message());
    };
    add_remark(shell_.SetRampMode(ramps.mode));
    for (const auto limit :
         {rrs::RampLimit::acceleration, rrs::RampLimit::deceleration, rrs::RampLimit::jerk}) {
        const rrs::JointPos& values = ramps.of(limit);
        add_remark(shell_.SetJointRampLimits(limit, {}, all_of(values)));
    }
}

Status ModuleMoveSettings::send(const motion::Move& move) {
    if (const Status status = send_kind(move); is_error_status(status)) return status;
    if (const Status status = send_feed(move.move_parameters); is_error_status(status)) return status;
    if (const Status status = send_joint_speeds(move); is_error_status(status)) return status;
    send_blending(move.move_parameters);
    send_ramps(move.move_parameters);
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::simulation
