// Calls of a module's services for moves of a program: first settings that the module does not have yet, then
// the target.

#include <cmath>
#include <utility>

#include "motion/planner/range_check.h"
#include "runtime/motion_sources/module_motion.h"

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

/// Gives each side its own modes: before a client calls, selections that moves have made since are undone.
void ModuleMotion::before_call() {
    if (called_by_program_) return;
    const SelectedModes sent = std::exchange(sent_modes_, {});
    if (!sent.rapid) return;
    run_as_program([&] {
        RcsShell::SetRapid(client_selections_.move_parameters.rapid);
        SelectTargetType(client_selections_.target_type);
        RcsShell::SelectMotionType(client_selections_.motion_type);
        RcsShell::SetCartesianOrientationSpeed(client_selections_.move_parameters.orientation_speed_rad_s);
        if (client_selections_.move_parameters.position_speed_mm_s > 0)
            RcsShell::SetCartesianPositionSpeed(client_selections_.move_parameters.position_speed_mm_s);
        if (sent.joint_speeds) RcsShell::SetJointSpeeds({}, all_of(client_joint_speeds_));
    });
}

Status ModuleMotion::SelectMotionType(MotionType type) {
    const Status status = RcsShell::SelectMotionType(type);
    if (!is_error_status(status)) client_selections_.motion_type = type;
    return status;
}

Status ModuleMotion::SetRapid(bool on) {
    const Status status = RcsShell::SetRapid(on);
    if (!is_error_status(status)) client_selections_.move_parameters.rapid = on;
    return status;
}

Status ModuleMotion::SetCartesianPositionSpeed(double speed_mm_s) {
    const Status status = RcsShell::SetCartesianPositionSpeed(speed_mm_s);
    if (!is_error_status(status)) client_selections_.move_parameters.position_speed_mm_s = speed_mm_s;
    return status;
}

Status ModuleMotion::SetCartesianOrientationSpeed(double speed_rad_s) {
    const Status status = RcsShell::SetCartesianOrientationSpeed(speed_rad_s);
    if (!is_error_status(status)) client_selections_.move_parameters.orientation_speed_rad_s = speed_rad_s;
    return status;
}

Status ModuleMotion::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    const Status status = RcsShell::SetJointSpeeds(joints, speeds);
    if (is_error_status(status)) return status;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        client_joint_speeds_[joints.empty() ? static_cast<Eigen::Index>(i) : joints[i]] = speeds[i];
    return status;
}

motion::PlanError ModuleMotion::plan_error(Status status) {
    motion::PlanError error = last_error();
    error.status = status;
    return error;
}

motion::EnqueueResult ModuleMotion::to_put_result(Status status) {
    if (is_error_status(status)) return tl::unexpected(plan_error(status));
    if (status == Status::RRS_MOTION_TIME_RAISED) return motion::TimeRaised{};
    return {};
}

motion::PlanResult ModuleMotion::start_at(const rrs::JointPos& joints) {
    return run_as_program([&]() -> motion::PlanResult {
        Status status = Initialize();
        if (!is_error_status(status)) status = SetInitialPosition(rrs::CartPos::Identity(), joints, {});
        if (is_error_status(status)) return tl::unexpected(plan_error(status));
        return {};
    });
}

motion::PlanResult ModuleMotion::check_tcp(const std::optional<Eigen::Vector3d>& tcp_mm) {
    return run_as_program([&]() -> motion::PlanResult {
        const Status status = SetTipControl(tcp_mm.has_value(), tcp_mm.value_or(Eigen::Vector3d::Zero()));
        if (is_error_status(status)) return tl::unexpected(plan_error(status));
        return {};
    });
}

/// Sends the kind of the move's target and path. Poses are impossible without the services; joint values
/// continue with what the controller has.
Status ModuleMotion::set_move_kind(const motion::Move& move) {
    const TargetType target = move.goal.pose ? TargetType::cartesian : TargetType::joint;
    const MotionType type = move.via ? MotionType::circular : move.circle ? MotionType::linear : move.type;
    const auto is_fatal = [&](Status status) {
        return move.goal.pose ? is_error_status(status) : is_unsupported(status);
    };
    if (sent_modes_.target_type != target) {
        if (const Status status = SelectTargetType(target); is_fatal(status)) return status;
        sent_modes_.motion_type.reset();  // a module may go back to joint motion
    }
    sent_modes_.target_type = target;
    if (sent_modes_.motion_type != type) {
        const Status status = RcsShell::SelectMotionType(type);
        if (is_fatal(status)) return status;
        sent_modes_.joint_motion_only = status == Status::RRS_MOTION_TYPE_NOT_SUPPORTED;
    }
    sent_modes_.motion_type = type;
    if (sent_modes_.rapid == move.move_parameters.rapid) return Status::RRS_SUCCESS;
    const Status status = RcsShell::SetRapid(move.move_parameters.rapid);
    const bool has_no_rapid = !move.move_parameters.rapid && status == Status::RRS_SERVICE_NOT_SUPPORTED;
    if (is_unsupported(status) && !has_no_rapid) return status;
    sent_modes_.rapid = move.move_parameters.rapid;
    return Status::RRS_SUCCESS;
}

Status ModuleMotion::set_move_feed(const motion::MoveParameters& move_parameters) {
    const bool any_speed =
        move_parameters.rapid || move_parameters.motion_time_s > 0;  // will do: it does not hold
    const double position_mm_s = any_speed ? motion::kUnlimited : move_parameters.position_speed_mm_s;
    const double orientation_rad_s = any_speed ? motion::kUnlimited : move_parameters.orientation_speed_rad_s;
    if (move_parameters.rapid && sent_modes_.position_speed_mm_s) return Status::RRS_SUCCESS;
    if (sent_modes_.position_speed_mm_s != position_mm_s) {
        const Status status = RcsShell::SetCartesianPositionSpeed(position_mm_s);
        if (status != Status::RRS_SUCCESS && !any_speed) return status;
        sent_modes_.position_speed_mm_s = position_mm_s;
    }
    if (move_parameters.rapid) return Status::RRS_SUCCESS;
    if (sent_modes_.orientation_speed_rad_s != orientation_rad_s) {
        const Status status = RcsShell::SetCartesianOrientationSpeed(orientation_rad_s);
        if (status != Status::RRS_SUCCESS && !any_speed) return status;
        sent_modes_.orientation_speed_rad_s = orientation_rad_s;
    }
    return move_parameters.motion_time_s > 0 ? SetMotionTime(move_parameters.motion_time_s)
                                             : Status::RRS_SUCCESS;
}

/// Returns the speeds for a line of joint values that are independent, because none of the joints carries the
/// tool. They move evenly, all together as fast as the feed says, which is that of the slides if some move.
rrs::JointPos ModuleMotion::move_joint_speeds(const motion::Move& move) const {
    rrs::JointPos speeds = rrs::JointPos::Constant(target_.size(), motion::kUnlimited);
    if (move.move_parameters.rapid || move.move_parameters.motion_time_s > 0) return speeds;
    const rrs::JointPos displacement = (move.goal.joints - target_).cwiseAbs();
    rrs::JointPos prismatic_displacement = displacement;
    for (Eigen::Index i = 0; i < displacement.size(); ++i) {
        if (setup_.joints[static_cast<std::size_t>(i)].kind == rrs::JointKind::revolute)
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

Status ModuleMotion::set_move_joint_speeds(const motion::Move& move) {
    if (!sent_modes_.joint_motion_only || move.goal.pose) return Status::RRS_SUCCESS;
    const rrs::JointPos speeds = move_joint_speeds(move);
    if (sent_modes_.joint_speeds == speeds) return Status::RRS_SUCCESS;
    sent_modes_.joint_speeds = speeds;
    const Status status = RcsShell::SetJointSpeeds({}, all_of(speeds));
    if (status != Status::RRS_SERVICE_NOT_SUPPORTED) return status;
    remarks_.emplace_back("the controller has no speeds of joints (SetJointSpeeds): joints move at its own");
    return Status::RRS_SUCCESS;
}

void ModuleMotion::set_move_blending(const motion::MoveParameters& move_parameters) {
    if (move_parameters.path_mode == sent_terms_.path_mode &&
        move_parameters.tolerance_mm == sent_terms_.tolerance_mm &&
        move_parameters.merge_tolerance_mm == sent_terms_.merge_tolerance_mm) {
        return;
    }
    sent_terms_.path_mode = move_parameters.path_mode;
    sent_terms_.tolerance_mm = move_parameters.tolerance_mm;
    sent_terms_.merge_tolerance_mm = move_parameters.merge_tolerance_mm;
    if (SetPathMode(move_parameters.path_mode, move_parameters.tolerance_mm,
                    move_parameters.merge_tolerance_mm) == Status::RRS_SERVICE_NOT_SUPPORTED) {
        remarks_.emplace_back(
            "the controller has no path modes (G61, G64): it passes the ends of moves in its own way");
    }
}

void ModuleMotion::set_move_ramps(const motion::MoveParameters& move_parameters) {
    if (move_parameters.ramps == sent_terms_.ramps) return;
    sent_terms_.ramps = move_parameters.ramps;
    motion::ProgrammedRamps ramps = move_parameters.ramps
                                        ? *move_parameters.ramps
                                        : motion::ProgrammedRamps(static_cast<int>(target_.size()));
    const auto send_terms = [&](Status status) {
        if (is_error_status(status)) remarks_.push_back(last_error().message);
    };
    send_terms(SetRampMode(ramps.mode));
    for (const auto limit :
         {rrs::RampLimit::acceleration, rrs::RampLimit::deceleration, rrs::RampLimit::jerk}) {
        const rrs::JointPos& values = ramps.of(limit);
        send_terms(SetJointRampLimits(limit, {}, all_of(values)));
    }
}

Status ModuleMotion::send_terms(const motion::Move& move) {
    if (const Status status = set_move_kind(move); is_error_status(status)) return status;
    if (const Status status = set_move_feed(move.move_parameters); is_error_status(status)) return status;
    if (const Status status = set_move_joint_speeds(move); is_error_status(status)) return status;
    set_move_blending(move.move_parameters);
    set_move_ramps(move.move_parameters);
    return Status::RRS_SUCCESS;
}

Status ModuleMotion::enqueue_move(const motion::Move& move) {
    if (const Status sent = send_terms(move); is_error_status(sent)) return sent;
    const auto enqueue = [&](rrs::TargetParam param, const motion::Goal& goal) {
        const rrs::CartPos pose = goal.pose ? goal.pose->pose : rrs::CartPos::Identity();
        return SetNextTarget(move.target_id, param, pose, goal.pose ? target_ : goal.joints, {}, 0);
    };
    if (move.circle) {
        return SetNextArcTarget(move.target_id, move.circle->center_mm, move.circle->axis,
                                move.circle->sweep_rad, rrs::CartPos::Identity(), move.goal.joints);
    }
    if (move.via) {
        if (const Status via = enqueue(rrs::TargetParam::via, *move.via); is_error_status(via)) return via;
    }
    return enqueue(rrs::TargetParam::end, move.goal);
}

/// Checks ranges first: a module rejects positions past a range with its own message, and the messages of the
/// machine's axes say more.
motion::EnqueueResult ModuleMotion::enqueue(const motion::Move& move) {
    if (move.goal.pose && !move.goal.pose->group_joints.empty()) {
        return tl::unexpected(motion::PlanError{
            .status = Status::RRS_MODE_NOT_SUPPORTED,
            .message = "A controller module knows no groups of axes; lead their axes by words (G0, G1)."});
    }
    return run_as_program([&]() -> motion::EnqueueResult {
        const Status status = enqueue_move(move);
        if (status == Status::RRS_JOINT_LIMIT && !move.goal.pose) {
            if (const auto in_range = motion::check_target_ranges(setup_, move.goal.joints); !in_range)
                return tl::unexpected(in_range.error());
        }
        return to_put_result(status);
    });
}

Status ModuleMotion::enqueue_move_until(const motion::Move& move, const motion::StopSearch& search) {
    const Status status = enqueue_move(move);
    while (!is_error_status(status)) {
        const double from_s = time_s_;
        const Status step_status = step();
        if (is_error_status(step_status)) return step_status;
        if (time_s_ > from_s && search(segment_)) return stop_here();
        if (step_status == Status::RRS_NEED_MORE_DATA) break;
    }
    return status;
}

motion::EnqueueResult ModuleMotion::enqueue_until(const motion::Move& move,
                                                  const motion::StopSearch& search) {
    plan_to_standstill(true);
    return run_as_program([&] { return to_put_result(enqueue_move_until(move, search)); });
}

motion::PlanResult ModuleMotion::enqueue_independent(const rrs::JointPos&) {
    return tl::unexpected(
        motion::PlanError{.status = Status::RRS_MODE_NOT_SUPPORTED,
                          .message = "A controller module has no axes that go by themselves."});
}

motion::PlanResult ModuleMotion::enqueue_dwell(const DwellRequest& request) {
    return run_as_program([&]() -> motion::PlanResult {
        const Status status = SetNextRest(request.target_id, request.dwell_s);
        if (is_error_status(status)) return tl::unexpected(plan_error(status));
        return {};
    });
}

}  // namespace gsim::simulation
