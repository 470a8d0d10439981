#include "runtime/simulator/run_outcome.h"

#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"

namespace gsim::simulation {

using rrs::Status;
using text::DiagnosticKind;

namespace {

const char* unit(const machine::Axis& axis) {
    return axis.kind == machine::AxisKind::rotary ? "deg" : "mm";
}

/// Maps an error of the planner to its kind.
DiagnosticKind diagnostic_kind(Status status) {
    switch (status) {
        case Status::RRS_JOINT_LIMIT: return DiagnosticKind::axis_limit;
        case Status::RRS_NO_SOLUTION: return DiagnosticKind::unreachable;
        case Status::RRS_CIRCLE_IMPOSSIBLE: return DiagnosticKind::arc;
        case Status::RRS_ZERO_SPEED: return DiagnosticKind::feed;
        default: return DiagnosticKind::service;
    }
}

}  // namespace

std::string cpu_limit_reached(const os::CpuLimit& limit) {
    if (limit.was_cancelled()) return "the run was cancelled";
    return fmt::format("the limit of {:.10g} s of processor time is reached (--max-cpu-seconds)",
                       limit.seconds());
}

bool RunOutcome::count_block(const SourceLocation& location) {
    if (++blocks_ <= limits_.max_blocks) return has_cpu_time(location);
    --blocks_;
    return stop(DiagnosticKind::run_limit,
                fmt::format("the limit of {} executed blocks is reached (--max-blocks)", limits_.max_blocks),
                location);
}

bool RunOutcome::has_cpu_time(const SourceLocation& location) {
    if (limits_.cpu == nullptr) return true;
    if (const double external_s = motion_.source().external_cpu_s(); external_s > 0)
        limits_.cpu->set_helper_time(external_s);
    if (!limits_.cpu->reached()) return true;
    return stop(DiagnosticKind::run_limit, cpu_limit_reached(*limits_.cpu), location);
}

bool RunOutcome::stop_for_time(const SourceLocation& location) {
    return stop(
        DiagnosticKind::run_limit,
        fmt::format("the limit of {:.10g} s of machine time is reached (--max-time)", limits_.max_time_s),
        location);
}

bool RunOutcome::fail(DiagnosticKind kind, std::string message, const SourceLocation& location) {
    if (alarm_) return false;
    status_ = RunStatus::alarm;
    alarm_ = Alarm{};
    alarm_->kind = kind;
    alarm_->message = std::move(message);
    alarm_->location = location;
    alarm_->calls = calls_.open().now();
    return false;
}

bool RunOutcome::stop(DiagnosticKind kind, std::string message, const SourceLocation& location) {
    if (alarm_) return false;
    fail(kind, std::move(message), location);
    status_ = RunStatus::stopped;
    return false;
}

bool RunOutcome::fail_during(const MoveInfo& move, Alarm alarm) {
    status_ = RunStatus::alarm;
    alarm.location = ids_.location_of(move);
    alarm.calls = calls_.open().at(move.target_id);
    alarm_ = std::move(alarm);
    return false;
}

bool RunOutcome::fail(const motion::PlanError& error, const SourceLocation& location) {
    if (alarm_) return false;
    if (is_past_max_time()) return stop_for_time(location);
    if (error.joint < 0) return fail(diagnostic_kind(error.status), error.message, location);
    const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(error.joint)];
    if (error.status == Status::RRS_JOINT_LIMIT) return fail_past_range(axis, error, location);
    fail(diagnostic_kind(error.status), fmt::format("axis {}: {}", axis.letter, error.message), location);
    alarm_->axis = axis.letter;
    return false;
}

bool RunOutcome::fail_past_range(const machine::Axis& axis, const motion::PlanError& error,
                                 const SourceLocation& location) {
    const double value = text::unsigned_zero(machine::axis_value(axis, error.value));
    const double limit = text::unsigned_zero(machine::axis_value(axis, error.limit));
    fail(DiagnosticKind::axis_limit,
         fmt::format("axis {} would move to {:.10g} {}, past its limit of {:.10g} {}", axis.letter, value,
                     unit(axis), limit, unit(axis)),
         location);
    alarm_->axis = axis.letter;
    alarm_->value = value;
    alarm_->limit = limit;
    return false;
}

}  // namespace gsim::simulation
