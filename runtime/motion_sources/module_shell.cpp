#include "runtime/motion_sources/module_shell.h"

#include <cstddef>

#include <fmt/format.h>

namespace gsim::simulation {

using rrs::is_error_status;
using rrs::Status;

namespace {

constexpr double kDefaultStep_s = 0.001;

}  // namespace

ModuleShell::ModuleShell(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                         motion::SegmentSink& sink)
    : RcsShell(std::move(module), setup.joint_count()),
      step_s_(setup.controller.position_loop.servo_period_s > 0
                  ? setup.controller.position_loop.servo_period_s
                  : kDefaultStep_s),
      max_time_s_(max_time_s),
      segments_(setup.joint_count(), setup.position_joints, sink),
      target_(rrs::JointPos::Zero(setup.joint_count())),
      client_joint_speeds_(rrs::JointPos::Constant(setup.joint_count(), motion::kUnlimited)) {}

void ModuleShell::before_call() {
    if (called_by_program_) return;
    const ModuleModes sent = std::exchange(move_modes_, {});
    if (!sent.rapid) return;
    run_as_program([&] {
        const motion::MoveParameters& client = client_selections_.move_parameters;
        RcsShell::SetRapid(client.rapid);
        SelectTargetType(client_selections_.target_type);
        RcsShell::SelectMotionType(client_selections_.motion_type);
        RcsShell::SetCartesianOrientationSpeed(client.orientation_speed_rad_s);
        if (client.position_speed_mm_s > 0) RcsShell::SetCartesianPositionSpeed(client.position_speed_mm_s);
        if (sent.joint_speeds) {
            RcsShell::SetJointSpeeds(
                {}, {client_joint_speeds_.data(), static_cast<std::size_t>(client_joint_speeds_.size())});
        }
    });
}

std::string ModuleShell::last_message() {
    std::string message;
    run_as_program([&] { GetMessage(message); });
    if (message.empty()) message = "the module gives no reason";
    return error() || message.find(name()) == 0 ? message : fmt::format("{}: {}", name(), message);
}

Status ModuleShell::Initialize() {
    const Status status = RcsShell::Initialize();
    return is_error_status(status) ? status : SetInterpolationTime(step_s_);
}

Status ModuleShell::SelectTargetType(rrs::TargetType type) {
    const Status status = RcsShell::SelectTargetType(type);
    if (is_error_status(status)) return status;
    target_type_ = type;
    if (!called_by_program_) client_selections_.target_type = type;
    return status;
}

Status ModuleShell::SelectMotionType(rrs::MotionType type) {
    const Status status = RcsShell::SelectMotionType(type);
    if (!is_error_status(status) && !called_by_program_) client_selections_.motion_type = type;
    return status;
}

Status ModuleShell::SetRapid(bool on) {
    const Status status = RcsShell::SetRapid(on);
    if (!is_error_status(status) && !called_by_program_) client_selections_.move_parameters.rapid = on;
    return status;
}

Status ModuleShell::SetCartesianPositionSpeed(double speed_mm_s) {
    const Status status = RcsShell::SetCartesianPositionSpeed(speed_mm_s);
    if (!is_error_status(status) && !called_by_program_)
        client_selections_.move_parameters.position_speed_mm_s = speed_mm_s;
    return status;
}

Status ModuleShell::SetCartesianOrientationSpeed(double speed_rad_s) {
    const Status status = RcsShell::SetCartesianOrientationSpeed(speed_rad_s);
    if (!is_error_status(status) && !called_by_program_)
        client_selections_.move_parameters.orientation_speed_rad_s = speed_rad_s;
    return status;
}

Status ModuleShell::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    const Status status = RcsShell::SetJointSpeeds(joints, speeds);
    if (is_error_status(status) || called_by_program_) return status;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        client_joint_speeds_[joints.empty() ? static_cast<Eigen::Index>(i) : joints[i]] = speeds[i];
    return status;
}

/// Returns a target in joint values; for a pose, by the module's own kinematics.
rrs::JointPos ModuleShell::solve_joints(const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (target_type_ == rrs::TargetType::joint) return joints.size() == target_.size() ? joints : target_;
    rrs::JointPos result = target_;
    GetInverseKinematics(cartesian, target_, result);
    return result;
}

Status ModuleShell::SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                       std::string_view configuration) {
    step_to_end();
    const Status status = RcsShell::SetInitialPosition(cartesian, joints, configuration);
    if (is_error_status(status)) return status;
    target_ = solve_joints(cartesian, joints);
    segments_.set_position(target_);
    has_position_ = true;
    return status;
}

/// Announces a series of consecutive calls, so that a module in a separate process need not be queried for
/// each step.
template <typename Call>
Status ModuleShell::call_with_prefetch(rrs::RcsPrefetch what, const Call& call) {
    announce(what, targets_.is_reported());
    const Status status = call();
    announce(rrs::RcsPrefetch::unknown, false);
    return status;
}

/// Repeats the call until the module's queue has space.
template <typename Call>
Status ModuleShell::retry_until_accepted(const Call& call) {
    Status status = call_with_prefetch(rrs::RcsPrefetch::if_full, call);
    while (status == Status::RRS_QUEUE_FULL) {
        if (const Status step_status = step_to_target(); is_error_status(step_status)) return step_status;
        status = call_with_prefetch(rrs::RcsPrefetch::if_full, call);
    }
    return status;
}

Status ModuleShell::on_queued(Status status, rrs::TargetId id, rrs::TargetParam param,
                              const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (is_error_status(status) || param == rrs::TargetParam::via) return status;
    target_ = solve_joints(cartesian, joints);
    targets_.add(id);
    return status;
}

Status ModuleShell::SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                  const rrs::JointPos& joints, std::string_view configuration,
                                  double param_value) {
    const Status status = retry_until_accepted(
        [&] { return RcsShell::SetNextTarget(id, param, cartesian, joints, configuration, param_value); });
    return on_queued(status, id, param, cartesian, joints);
}

Status ModuleShell::SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param,
                                       const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                       std::string_view configuration, double param_value,
                                       std::string_view target_name) {
    const Status status = retry_until_accepted([&] {
        return RcsShell::SetNextNamedTarget(id, param, cartesian, joints, configuration, param_value,
                                            target_name);
    });
    return on_queued(status, id, param, cartesian, joints);
}

Status ModuleShell::SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                     const Eigen::Vector3d& axis, double sweep_rad,
                                     const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    const Status status = retry_until_accepted(
        [&] { return RcsShell::SetNextArcTarget(id, center_mm, axis, sweep_rad, cartesian, joints); });
    return on_queued(status, id, rrs::TargetParam::end, cartesian, joints);
}

Status ModuleShell::SetNextRest(rrs::TargetId id, double dwell_s) {
    const Status status = retry_until_accepted([&] { return RcsShell::SetNextRest(id, dwell_s); });
    if (is_error_status(status)) return status;
    progress_.add_dwell(dwell_s);
    targets_.add(id);
    return status;
}

Status ModuleShell::SetRestParameter(double dwell_s) {
    const Status status = RcsShell::SetRestParameter(dwell_s);
    if (!is_error_status(status)) progress_.add_dwell(dwell_s);
    return status;
}

Status ModuleShell::GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) {
    const Status status = RcsShell::GetNextStep(joints, pose, elapsed_s);
    return is_error_status(status) ? status : record(status, joints, elapsed_s);
}

Status ModuleShell::step() {
    if (segments_.time_s() > max_time_s_)
        return report_module_error(fmt::format("still moves after {:.10g} s of machine time", max_time_s_));
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    const Status status = GetNextStep(joints, pose, elapsed_s);
    if (!is_error_status(status) || error()) return status;
    return report_module_error(fmt::format("responded to GetNextStep with {}", rrs::name(status)));
}

Status ModuleShell::step_to_target() {
    return call_with_prefetch(rrs::RcsPrefetch::to_target, [this] {
        for (;;) {
            const Status status = step();
            if (is_error_status(status) || status == Status::RRS_TARGET_REACHED) return status;
            if (status == Status::RRS_NEED_MORE_DATA)
                return report_module_error("returned RRS_QUEUE_FULL, but its queue is empty");
        }
    });
}

void ModuleShell::step_to_end() {
    if (!has_position_) return;
    call_with_prefetch(rrs::RcsPrefetch::to_end, [this] {
        for (;;) {
            const Status status = step();
            if (is_error_status(status) || status == Status::RRS_NEED_MORE_DATA) return status;
        }
    });
}

Status ModuleShell::record(Status status, const rrs::JointPos& joints, double elapsed_s) {
    const bool moved = joints != segments_.position();
    if (const auto error = progress_.on_step(moved, elapsed_s)) return report_module_error(*error);
    if (elapsed_s > 0) {
        segments_.add_step(joints, elapsed_s, targets_.of_last_step(*this));
    } else if (const auto error = segments_.add_instant(joints)) {
        return report_module_error(*error);
    }
    if (status == Status::RRS_TARGET_REACHED) targets_.on_target_reached();
    return status;
}

Status ModuleShell::stop_and_cancel() {
    if (const Status stopped = StopMotion(); is_error_status(stopped)) return stopped;
    step_to_end();
    const Status cancelled = CancelMotion();
    if (is_error_status(cancelled)) return cancelled;
    targets_.clear();
    target_ = segments_.position();
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::simulation
