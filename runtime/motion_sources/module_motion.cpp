#include "runtime/motion_sources/module_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

using rrs::is_error_status;
using rrs::Status;

namespace {

constexpr double kDefaultStep_s = 0.001;
constexpr double kMaxIdle_s = 600;
constexpr std::uint64_t kMaxZeroTimeSteps = 1'000'000;
constexpr double kPositionTolerance = 1e-6;  // mm or rad: positions at one instant may differ by rounding

}  // namespace

ModuleMotion::ModuleMotion(rrs::RcsModule module, const motion::PlannerSetup& setup, double max_time_s,
                           motion::SegmentSink& sink)
    : RcsShell(std::move(module), setup.joint_count()),
      setup_(setup),
      step_s_(setup.controller.servo_period_s > 0 ? setup.controller.servo_period_s : kDefaultStep_s),
      max_time_s_(max_time_s),
      sink_(sink),
      reached_(rrs::JointPos::Zero(setup.joint_count())),
      target_(reached_),
      client_joint_speeds_(rrs::JointPos::Constant(setup.joint_count(), motion::kUnlimited)) {
    setup_.overtravel_log = nullptr;  // they let targets through; what a module refuses is refused
}

Status ModuleMotion::Initialize() {
    const Status status = RcsShell::Initialize();
    return is_error_status(status) ? status : SetInterpolationTime(step_s_);
}

Status ModuleMotion::SelectTargetType(rrs::TargetType type) {
    const Status status = RcsShell::SelectTargetType(type);
    if (is_error_status(status)) return status;
    target_type_ = type;
    if (!called_by_program_) client_selections_.target_type = type;
    return status;
}

/// Returns a target in joint values; for a pose, by the module's own kinematics.
rrs::JointPos ModuleMotion::solve_joints(const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (target_type_ == rrs::TargetType::joint) return joints.size() == target_.size() ? joints : target_;
    rrs::JointPos result = target_;
    GetInverseKinematics(cartesian, target_, result);
    return result;
}

Status ModuleMotion::SetInitialPosition(const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                        std::string_view configuration) {
    step_to_end();
    const Status status = RcsShell::SetInitialPosition(cartesian, joints, configuration);
    if (is_error_status(status)) return status;
    reached_ = target_ = solve_joints(cartesian, joints);
    has_position_ = true;
    return status;
}

/// Announces a series of consecutive calls, so that a module in a separate process need not be queried for
/// each step.
template <typename Call>
Status ModuleMotion::call_with_prefetch(rrs::RcsPrefetch what, const Call& call) {
    announce(what, reports_target_);
    const Status status = call();
    announce(rrs::RcsPrefetch::unknown, false);
    return status;
}

/// Repeats the call until the module's queue has space.
template <typename Call>
Status ModuleMotion::retry_until_room(const Call& call) {
    Status status = call_with_prefetch(rrs::RcsPrefetch::if_full, call);
    while (status == Status::RRS_QUEUE_FULL) {
        if (const Status step_status = step_to_target(); is_error_status(step_status)) return step_status;
        status = call_with_prefetch(rrs::RcsPrefetch::if_full, call);
    }
    return status;
}

Status ModuleMotion::on_queued(Status status, rrs::TargetId id, rrs::TargetParam param,
                               const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    if (is_error_status(status) || param == rrs::TargetParam::via) return status;
    target_ = solve_joints(cartesian, joints);
    pending_targets_.push_back(id);
    return status;
}

Status ModuleMotion::SetNextTarget(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                                   const rrs::JointPos& joints, std::string_view configuration,
                                   double param_value) {
    const Status status = retry_until_room(
        [&] { return RcsShell::SetNextTarget(id, param, cartesian, joints, configuration, param_value); });
    return on_queued(status, id, param, cartesian, joints);
}

Status ModuleMotion::SetNextNamedTarget(rrs::TargetId id, rrs::TargetParam param,
                                        const rrs::CartPos& cartesian, const rrs::JointPos& joints,
                                        std::string_view configuration, double param_value,
                                        std::string_view target_name) {
    const Status status = retry_until_room([&] {
        return RcsShell::SetNextNamedTarget(id, param, cartesian, joints, configuration, param_value,
                                            target_name);
    });
    return on_queued(status, id, param, cartesian, joints);
}

Status ModuleMotion::SetNextArcTarget(rrs::TargetId id, const Eigen::Vector3d& center_mm,
                                      const Eigen::Vector3d& axis, double sweep_rad,
                                      const rrs::CartPos& cartesian, const rrs::JointPos& joints) {
    const Status status = retry_until_room(
        [&] { return RcsShell::SetNextArcTarget(id, center_mm, axis, sweep_rad, cartesian, joints); });
    return on_queued(status, id, rrs::TargetParam::end, cartesian, joints);
}

Status ModuleMotion::SetNextRest(rrs::TargetId id, double dwell_s) {
    const Status status = retry_until_room([&] { return RcsShell::SetNextRest(id, dwell_s); });
    if (is_error_status(status)) return status;
    requested_dwell_s_ += dwell_s;
    pending_targets_.push_back(id);
    return status;
}

Status ModuleMotion::SetRestParameter(double dwell_s) {
    const Status status = RcsShell::SetRestParameter(dwell_s);
    if (!is_error_status(status)) requested_dwell_s_ += dwell_s;
    return status;
}

Status ModuleMotion::GetNextStep(rrs::JointPos& joints, rrs::CartPos& pose, double& elapsed_s) {
    const Status status = RcsShell::GetNextStep(joints, pose, elapsed_s);
    return is_error_status(status) ? status : record(status, joints, elapsed_s);
}

Status ModuleMotion::step() {
    if (time_s_ > max_time_s_)
        return report_module_error(fmt::format("still moves after {:.10g} s of machine time", max_time_s_));
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    const Status status = GetNextStep(joints, pose, elapsed_s);
    if (!is_error_status(status) || RcsShell::error()) return status;
    return report_module_error(fmt::format("answered GetNextStep with {}", rrs::name(status)));
}

Status ModuleMotion::step_to_target() {
    return call_with_prefetch(rrs::RcsPrefetch::to_target, [this] {
        for (;;) {
            const Status status = step();
            if (is_error_status(status) || status == Status::RRS_TARGET_REACHED) return status;
            if (status == Status::RRS_NEED_MORE_DATA)
                return report_module_error("answered RRS_QUEUE_FULL, but its queue is empty");
        }
    });
}

void ModuleMotion::step_to_end() {
    if (!has_position_) return;
    call_with_prefetch(rrs::RcsPrefetch::to_end, [this] {
        for (;;) {
            const Status status = step();
            if (is_error_status(status) || status == Status::RRS_NEED_MORE_DATA) return status;
        }
    });
}

Status ModuleMotion::record(Status status, const rrs::JointPos& joints, double elapsed_s) {
    const bool moved = joints != reached_;
    if (const Status checked = check_progress(moved, elapsed_s); is_error_status(checked)) return checked;
    if (elapsed_s > 0) {
        fill_segment(joints, elapsed_s);
        sink_.on_segment(segment_);
        time_s_ = segment_.end_s();
    } else if ((joints - reached_).cwiseAbs().maxCoeff() > kPositionTolerance) {
        return report_module_error("answered GetNextStep with a jump: a joint moved in no time");
    }
    reached_ = joints;
    if (status == Status::RRS_TARGET_REACHED && !pending_targets_.empty()) pending_targets_.pop_front();
    return status;
}

// A foreign planner may respond without end; each form of that ends here.
Status ModuleMotion::check_progress(bool moved, double elapsed_s) {
    idle_s_ = moved ? 0 : idle_s_ + elapsed_s;
    zero_time_steps_ = elapsed_s > 0 ? 0 : zero_time_steps_ + 1;
    if (zero_time_steps_ > kMaxZeroTimeSteps)
        return report_module_error("answers GetNextStep, but its time stands still");
    if (idle_s_ > kMaxIdle_s + requested_dwell_s_)
        return report_module_error(fmt::format("has not moved for {:.10g} s, though targets wait", idle_s_));
    return Status::RRS_SUCCESS;
}

// A module that was built before GetTargetOfLastStep existed responds that it has no such service; then
// targets are counted as it reaches them.
rrs::TargetId ModuleMotion::step_target() {
    rrs::TargetId id = -1;
    if (reports_target_ && GetTargetOfLastStep(id) == Status::RRS_SUCCESS) {
        pending_targets_.clear();
        return id;
    }
    reports_target_ = false;
    return pending_targets_.empty() ? -1 : pending_targets_.front();
}

void ModuleMotion::fill_segment(const rrs::JointPos& joints, double elapsed_s) {
    const rrs::JointPos displacement = joints - reached_;
    double square_mm2 = 0;
    for (const int joint : setup_.position_joints)
        square_mm2 += joint < 0 ? 0 : displacement[joint] * displacement[joint];
    segment_.target_id = step_target();
    segment_.start_s = time_s_;
    segment_.duration_s = elapsed_s;
    segment_.length_mm = std::sqrt(square_mm2);
    segment_.start = reached_;
    segment_.end = joints;
    segment_.position_joints = setup_.position_joints;
    segment_.limited_by = {.kind = motion::LimitKind::unknown};
    const double length = segment_.length_mm > 0 ? segment_.length_mm : displacement.norm();
    segment_.kind = length > 0 ? motion::SegmentKind::linear : motion::SegmentKind::rest;
    // The motion of a module between two steps is unknown: the joints are taken to move evenly.
    const motion::LawSection section{
        .duration_s = elapsed_s, .s0 = 0, .v0 = length / elapsed_s, .a0 = 0, .jerk = 0};
    segment_.master = motion::TimeLaw::from_sections({&section, 1});
}

void ModuleMotion::plan_to_standstill(bool waits) {
    run_as_program([&] {
        ComeToRest(waits ? rrs::RestReason::wait : rrs::RestReason::query);
        step_to_end();
    });
}

Status ModuleMotion::stop_here() {
    if (const Status stopped = StopMotion(); is_error_status(stopped)) return stopped;
    step_to_end();
    const Status cancelled = CancelMotion();
    if (is_error_status(cancelled)) return cancelled;
    pending_targets_.clear();
    target_ = reached_;
    return Status::RRS_SUCCESS;
}

void ModuleMotion::end_program() {
    run_as_program([&] {
        ComeToRest(rrs::RestReason::end);
        step_to_end();
    });
}

motion::PlanError ModuleMotion::last_error() {
    motion::PlanError error;
    run_as_program([&] { GetMessage(error.message); });
    if (error.message.empty()) error.message = "the module does not say why";
    if (!RcsShell::error() && error.message.find(name()) != 0)
        error.message = fmt::format("{}: {}", name(), error.message);
    return error;
}

}  // namespace gsim::simulation
