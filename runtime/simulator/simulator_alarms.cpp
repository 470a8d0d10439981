// End of a run of Simulator before its program ends.

#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"
#include "runtime/simulator/simulator.h"

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

std::string zone_hit_text(const ZoneHit& hit) {
    std::string at;
    std::string walls;
    for (std::size_t i = 0; i < hit.limits.size(); ++i) {
        const char letter = static_cast<char>('X' + i);
        if (hit.tool_mm[i])
            at += fmt::format("{}{}{}", at.empty() ? "" : " ", letter, text::fixed(*hit.tool_mm[i], 4));
        if (!hit.limits[i]) continue;
        walls += fmt::format("{}{} {:.10g} to {:.10g}", walls.empty() ? "" : ", ", letter,
                             text::unsigned_zero(hit.limits[i]->min_mm),
                             text::unsigned_zero(hit.limits[i]->max_mm));
    }
    const char* location = hit.stay_inside ? "inside" : "outside";
    const std::string what =
        hit.is_initial ? fmt::format("the tool is not {} {} when that comes into force", location, hit.zone)
                       : fmt::format("the tool {} {} on axis {}", hit.stay_inside ? "leaves" : "enters",
                                     hit.zone, static_cast<char>('X' + hit.axis));
    return fmt::format(
        "{}, at {} mm after {:.9g} s; the zone is {} mm (machine coordinates of the tool's end), and the "
        "tool "
        "must stay {} it",
        what, at, hit.time_s, walls, location);
}

}  // namespace

std::string cpu_limit_reached(const os::CpuLimit& limit) {
    if (limit.was_cancelled()) return "the run was cancelled";
    return fmt::format("the limit of {:.10g} s of processor time is reached (--max-cpu-seconds)",
                       limit.seconds());
}

bool Simulator::has_cpu_time(const SourceLocation& location) {
    if (limits_.cpu == nullptr) return true;
    if (const double external_s = motion_->external_cpu_s(); external_s > 0)
        limits_.cpu->set_helper_time(external_s);
    if (!limits_.cpu->reached()) return true;
    return stop(DiagnosticKind::run_limit, cpu_limit_reached(*limits_.cpu), location);
}

bool Simulator::stop_for_time(const SourceLocation& location) {
    return stop(
        DiagnosticKind::run_limit,
        fmt::format("the limit of {:.10g} s of machine time is reached (--max-time)", limits_.max_time_s),
        location);
}

bool Simulator::fail(DiagnosticKind kind, std::string message, const SourceLocation& location) {
    if (alarm_) return false;
    status_ = RunStatus::alarm;
    alarm_ = Alarm{};
    alarm_->kind = kind;
    alarm_->message = std::move(message);
    alarm_->location = location;
    alarm_->calls = calls_.now();
    return false;
}

bool Simulator::stop(DiagnosticKind kind, std::string message, const SourceLocation& location) {
    if (alarm_) return false;
    fail(kind, std::move(message), location);
    status_ = RunStatus::stopped;
    return false;
}

void Simulator::warn_if_singular(const AxisVector& axes, const SourceLocation& location) {
    const std::vector<int> joints = setup_.kinematics->aligned_joints(to_joints(axes));
    if (joints.empty()) return;
    std::string letters;
    for (const int joint : joints) {
        if (!letters.empty()) letters += " and ";
        letters += machine_.axes[static_cast<std::size_t>(joint)].letter;
    }
    const std::string at = location.file < files_.size() && location.line > 0
                               ? fmt::format("{}:{}: ", files_[location.file], location.line)
                               : std::string();
    warn(
        fmt::format("{}the pose is singular: axes {} line up, and can turn against each other while the tool "
                    "stands",
                    at, letters));
}

void Simulator::set_zone_data(const machine::MachineData& data) {
    zones_.add_zones(data);
    for (const char letter : zones_.missing_axes()) {
        warn(fmt::format("the machine has no linear axis {}, and zones no walls there", letter));
    }
}

/// An unexpected move has no source location, so the last move's is used.
const SourceLocation& Simulator::source_location(const MoveInfo& move) const {
    return move.location.line > 0 ? move.location : last_location_;
}

/// Raises an alarm of a move that is running. The machine reaches it before later parts of the program, so
/// this alarm replaces another one.
void Simulator::fail_during_motion(const MoveInfo& move, DiagnosticKind kind, std::string message) {
    alarm_.reset();
    fail(kind, std::move(message), source_location(move));
    alarm_->calls = calls_.at(move.target_id);
}

/// Events after the time limit do not happen.
bool Simulator::fail_in_zone() {
    const ZoneHit& hit = *zones_.hit();
    if (hit.time_s > limits_.max_time_s) return stop_for_time(recorder_.move().location);
    fail_during_motion(recorder_.move(), DiagnosticKind::zone, zone_hit_text(hit));
    alarm_->axis = static_cast<char>('X' + hit.axis);
    alarm_->value = hit.tool_mm[hit.axis];
    alarm_->limit = hit.wall_mm;
    events_.truncate(hit.time_s);
    return false;
}

/// Converts an error of the planner into an alarm in terms of the machine's axes.
bool Simulator::report_plan_error(const motion::PlanError& error, const SourceLocation& location) {
    if (motion_->time_s() > limits_.max_time_s) return stop_for_time(location);
    if (error.joint < 0) return fail(diagnostic_kind(error.status), error.message, location);
    const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(error.joint)];
    if (error.status != Status::RRS_JOINT_LIMIT) {
        fail(diagnostic_kind(error.status), fmt::format("axis {}: {}", axis.letter, error.message), location);
        alarm_->axis = axis.letter;
        return false;
    }
    const double value = text::unsigned_zero(machine::axis_value(axis, error.value));
    const double limit = text::unsigned_zero(machine::axis_value(axis, error.limit));
    fail(DiagnosticKind::axis_limit,
         fmt::format("axis {} would go to {:.10g} {}, past its limit of {:.10g} {}", axis.letter, value,
                     unit(axis), limit, unit(axis)),
         location);
    alarm_->axis = axis.letter;
    alarm_->value = value;
    alarm_->limit = limit;
    return false;
}

}  // namespace gsim::simulation
