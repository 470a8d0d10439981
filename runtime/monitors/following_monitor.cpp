#include "runtime/monitors/following_monitor.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::simulation {

FollowingErrorMonitor::FollowingErrorMonitor(const FollowingSetup& setup, double step_s)
    : program_(setup.planner.position_joints),
      motion_(setup, step_s),
      axes_(setup.machine.axes.size()),
      squared_errors_(setup.machine.axes.size()) {
    motion_.set_programmed_path(program_);
    const std::vector<dynamics::ServoLoop> loops = servo_loops(setup.machine);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const machine::Axis& axis = setup.machine.axes[i];
        report_.axes.push_back({.letter = axis.letter,
                                .rotary = axis.kind == machine::AxisKind::rotary,
                                .gain_1_s = loops[i].gain_1_s,
                                .constant_speed_lag_s = loops[i].constant_speed_lag_s()});
    }
    report_.band_mm = setup.machine.controller.position_loop.in_position_mm;
    report_.band_deg = setup.machine.controller.position_loop.in_position_deg;
}

void FollowingErrorMonitor::begin(const rrs::JointPos& start) {
    motion_.begin(start);
}

void FollowingErrorMonitor::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    const auto inspect_step = [this](double from_s, double to_s) { this->inspect_step(from_s, to_s); };
    motion_.enter(segment, info, inspect_step);  // a dwell in front of it is the move's before
    const bool between_moves = segment.kind == motion::SegmentKind::rest && info.location.line == 0;
    if (!between_moves && info.target_id != move_.target_id) {
        if ((info.kind == MoveKind::rapid) != (move_.kind == MoveKind::rapid)) {
            feed_.pause();
            rapid_.pause();
            program_peak_.pause();
        }
        previous_location_ = move_.location;
        move_start_s_ = segment.start_s;
        move_ = info;
    }
    motion_.leave(inspect_step);
}

/// Handles that a peak may be found a little late.
const SourceLocation& FollowingErrorMonitor::location_at(double t_s) const {
    return t_s <= move_start_s_ && previous_location_.line > 0 ? previous_location_ : move_.location;
}

double FollowingErrorMonitor::axis_error(std::size_t axis, double joint_error) const {
    return report_.axes[axis].rotary ? joint_error / kRadPerDeg : joint_error;
}

// Integrates the square of an error by Simpson's rule: over a step it is smooth.
void FollowingErrorMonitor::inspect_step(double from_s, double to_s) {
    const rrs::JointPos from = motion_.errors(from_s);
    const rrs::JointPos middle = motion_.errors((from_s + to_s) / 2);
    const FollowingInstant to = motion_.at(to_s);
    for (std::size_t axis = 0; axis < squared_errors_.size(); ++axis) {
        const auto joint = static_cast<Eigen::Index>(axis);
        squared_errors_[axis].add((to_s - from_s) / 6 *
                                  (from[joint] * from[joint] + 4 * middle[joint] * middle[joint] +
                                   to.errors[joint] * to.errors[joint]));
        inspect_axis(axis, to_s, to.errors[joint]);
    }
    if ((is_rapid() ? rapid_ : feed_).is_paused()) inspect_tcp(motion_.at(from_s));
    inspect_tcp(to);
    if (is_rapid()) return;
    if (program_peak_.is_paused()) inspect_program(motion_.at(from_s));
    inspect_program(to);
}

void FollowingErrorMonitor::inspect_axis(std::size_t axis, double t_s, double error) {
    const auto joint = static_cast<Eigen::Index>(axis);
    const auto abs_error_at = [&](double at_s) { return std::abs(motion_.errors(at_s)[joint]); };
    if (!axes_[axis].add(t_s, std::abs(error), abs_error_at)) return;
    AxisFollowing& axis_report = report_.axes[axis];
    axis_report.peak_t_s = axes_[axis].greatest_s();
    axis_report.peak = axis_error(axis, motion_.errors(axis_report.peak_t_s)[joint]);
    axis_report.peak_location = location_at(axis_report.peak_t_s);
}

void FollowingErrorMonitor::inspect_tcp(const FollowingInstant& instant) {
    if (!instant.contour_error_mm) {
        feed_.pause();
        rapid_.pause();
        return;
    }
    const bool rapid = is_rapid();
    PeakFinder& peak = rapid ? rapid_ : feed_;
    const auto error_at = [&](double at_s) { return motion_.at(at_s).contour_error_mm.value_or(0); };
    if (!peak.add(instant.t_s, *instant.contour_error_mm, error_at)) return;
    (rapid ? report_.rapid : report_.feed) = {peak.max(), peak.greatest_s(), location_at(peak.greatest_s())};
}

void FollowingErrorMonitor::inspect_program(const FollowingInstant& instant) {
    if (!instant.program_deviation_mm) return program_peak_.pause();
    const auto error_at = [&](double at_s) { return motion_.at(at_s).program_deviation_mm.value_or(0); };
    if (!program_peak_.add(instant.t_s, *instant.program_deviation_mm, error_at)) return;
    report_.program = {program_peak_.max(), program_peak_.greatest_s(),
                       location_at(program_peak_.greatest_s())};
}

void FollowingErrorMonitor::end(double end_s) {
    motion_.go_to(end_s, [this](double from_s, double to_s) { inspect_step(from_s, to_s); });
    const rrs::JointPos errors = motion_.errors(end_s);
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
        AxisFollowing& axis_report = report_.axes[axis];
        axis_report.end = axis_error(axis, errors[static_cast<Eigen::Index>(axis)]);
        axis_report.rms =
            end_s > 0 ? axis_error(axis, std::sqrt(std::max(0.0, squared_errors_[axis].value()) / end_s)) : 0;
    }
    report_.in_position_s.reset();
    if (const double settling_s = settling_time_s(end_s);
        motion_.is_in_position(motion_.errors(motion_.now_s())))
        report_.in_position_s = settling_s;
}

/// Returns when the axes are in their bands to stay, as far as they are followed: s after the end.
double FollowingErrorMonitor::settling_time_s(double end_s) {
    constexpr int kHalvings = 40;
    double settling_time_s = end_s;
    const auto inspect_step = [&](double from_s, double to_s) {
        const auto in = [&](double t_s) { return motion_.is_in_position(motion_.errors(t_s)); };
        if (!in(to_s)) {
            settling_time_s = to_s;
            return;
        }
        if (in(from_s)) return;
        double outside_s = from_s, in_s = to_s;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle_s = (outside_s + in_s) / 2;
            (in(middle_s) ? in_s : outside_s) = middle_s;
        }
        settling_time_s = in_s;
    };
    motion_.go_to(end_s + motion_.longest_s(), inspect_step);
    return settling_time_s - end_s;
}

}  // namespace gsim::simulation
