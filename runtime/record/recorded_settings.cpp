// Modal selections of a program, as actions and offsets of the path.

#include <array>

#include <fmt/format.h>

#include "runtime/record/action_name.h"
#include "runtime/record/path_recorder.h"

namespace gsim::record {

using simulation::AxisVector;

namespace {

constexpr std::array<std::string_view, 4> kRamps = {"machine", "linear", "s_curve", "infinite"};
constexpr std::array<std::string_view, 3> kRampLimits = {"acceleration", "deceleration", "jerk"};

}  // namespace

// Records that the next motion begins at standstill, which a dwell or a switch says already.
void PathRecorder::standstill(const AxisVector& at) {
    standstill_pending_ = standstill_pending_ || moved_since_standstill_;
    standstill_position_ = at;
    moved_since_standstill_ = false;
}

void PathRecorder::spindle_speed(const AxisVector& at, double rev_min) {
    if (spindle_rev_min_ == rev_min) return;
    spindle_rev_min_ = rev_min;
    add_action(at, fmt::format("speed {}", number_text(rev_min)));
}

void PathRecorder::path_mode(const AxisVector& at, const simulation::PathModeSettings& settings) {
    if (settings == path_mode_settings_) return;
    path_mode_settings_ = settings;
    switch (settings.mode) {
        case rrs::PathMode::exact_stop: return add_action(at, "path_mode exact_stop");
        case rrs::PathMode::exact_path: return add_action(at, "path_mode exact_path");
        case rrs::PathMode::continuous: break;
    }
    if (settings.tolerance_mm == 0 && settings.merge_tolerance_mm == 0)
        return add_action(at, "path_mode continuous");
    add_action(at, fmt::format("path_mode continuous {} {}", number_text(settings.tolerance_mm),
                               number_text(settings.merge_tolerance_mm)));
}

void PathRecorder::exact_stop_once(const AxisVector& at) {
    add_action(at, "exact_stop_once");
}

void PathRecorder::ramps(const AxisVector& at, rrs::RampMode mode) {
    add_action(at, fmt::format("ramps {}", kRamps[static_cast<std::size_t>(mode)]));
}

void PathRecorder::ramp_limit(const AxisVector& at, rrs::RampLimit limit, const machine::Axis& axis,
                              double value) {
    add_action(
        at, fmt::format("ramp_limit {} {} {} {}", kRampLimits[static_cast<std::size_t>(limit)], axis.letter,
                        number_text(value), axis.kind == machine::AxisKind::rotary ? "deg" : "mm"));
}

void PathRecorder::no_ramp_limits(const AxisVector& at) {
    add_action(at, "ramp_limits machine");
}

void PathRecorder::work_offset(const simulation::WorkOffset& offset) {
    work_offset_ = offset.name;
    work_offsets_.insert_or_assign(offset.name, path::WorkOffset{offset.origin, offset.rotation_deg});
    if (!offset.moved) return;
    notes_.insert(
        fmt::format("recorded path: the program has moved the work offset G{}; positions refer to the origin "
                    "before the change, and programs written from the path do not move it",
                    offset.name));
}

void PathRecorder::tool_offset(const Eigen::Vector3d& offset_mm) {
    if (offset_mm.isZero(0)) return;
    notes_.insert(
        "recorded path: tool offsets (G43) are included in its positions; programs written from the path "
        "have none");
}

}  // namespace gsim::record
