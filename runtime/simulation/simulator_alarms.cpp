// How a run of Simulator ends before its program does.

#include <fmt/format.h>

#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

const char* unit(const machine::Axis& axis) {
    return axis.kind == machine::AxisKind::rotary ? "deg" : "mm";
}

}  // namespace

bool Simulator::stop_for_time(const Place& place) {
    return stop(
        fmt::format("the limit of {:.10g} s of machine time is reached (--max-time)", limits_.max_time_s),
        place);
}

bool Simulator::fail(std::string message, const Place& place) {
    if (alarm_) return false;
    status_ = RunStatus::alarm;
    alarm_ = Alarm{};
    alarm_->message = std::move(message);
    alarm_->place = place;
    alarm_->calls.assign(calls_.rbegin(), calls_.rend());
    return false;
}

bool Simulator::stop(std::string message, const Place& place) {
    if (alarm_) return false;
    fail(std::move(message), place);
    status_ = RunStatus::stopped;
    return false;
}

void Simulator::warn_if_singular(const AxisVector& axes, const Place& place) {
    const std::vector<int> joints = setup_.kinematics->lined_up(to_joints(axes));
    if (joints.empty()) return;
    std::string letters;
    for (const int joint : joints) {
        if (!letters.empty()) letters += " and ";
        letters += machine_.axes[static_cast<std::size_t>(joint)].letter;
    }
    const std::string at = place.file < files_.size() && place.line > 0
                               ? fmt::format("{}:{}: ", files_[place.file], place.line)
                               : std::string();
    warn(
        fmt::format("{}the pose is singular: axes {} line up, and can turn against each other while the tool "
                    "stands",
                    at, letters));
}

/// Turns the planner's last refusal into an alarm in terms of the machine's axes.
bool Simulator::refused(const Place& place) {
    if (motion_->time_s() > limits_.max_time_s) return stop_for_time(place);
    const motion::PlanError error = motion_->last_error();
    if (error.status != Status::RRS_JOINT_LIMIT || error.joint < 0) return fail(error.message, place);
    const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(error.joint)];
    const double value = machine::axis_value(axis, error.value);
    const double limit = machine::axis_value(axis, error.limit);
    fail(fmt::format("axis {} would go to {:.10g} {}, past its limit of {:.10g} {}", axis.letter, value,
                     unit(axis), limit, unit(axis)),
         place);
    alarm_->axis = axis.letter;
    alarm_->value = value;
    alarm_->limit = limit;
    return false;
}

}  // namespace gsim::simulation
