#include "runtime/monitors/following_watch.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace gsim::simulation {

FollowingWatch::FollowingWatch(const FollowingSetup& setup, double step_s)
    : program_(setup.planner.position_joints),
      motion_(setup, step_s),
      axes_(setup.machine.axes.size()),
      squares_(setup.machine.axes.size()) {
    motion_.follow_program(program_);
    const std::vector<dynamics::ServoLoop> loops = servo_loops(setup.machine);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const machine::Axis& axis = setup.machine.axes[i];
        report_.axes.push_back({.letter = axis.letter,
                                .rotary = axis.kind == machine::AxisKind::rotary,
                                .gain_1_s = loops[i].gain_1_s,
                                .behind_s = loops[i].behind_s()});
    }
    report_.band_mm = setup.machine.controller.in_position_mm;
    report_.band_deg = setup.machine.controller.in_position_deg;
}

void FollowingWatch::begin(const rrs::JointPos& start) {
    motion_.begin(start);
}

void FollowingWatch::take(const motion::Segment& segment, const MoveInfo& info) {
    const auto look = [this](double from_s, double to_s) { this->look(from_s, to_s); };
    motion_.enter(segment, info, look);  // a dwell in front of it is the move's before
    const bool between_moves = segment.kind == motion::SegmentKind::rest && info.place.line == 0;
    if (!between_moves && info.target_id != move_.target_id) {
        if ((info.kind == MoveKind::rapid) != (move_.kind == MoveKind::rapid)) {
            feed_.pause();
            rapid_.pause();
            of_program_.pause();
        }
        before_ = move_.place;
        move_s_ = segment.start_s;
        move_ = info;
    }
    motion_.leave(look);
}

/// Handles that a peak may be found a little late.
const Place& FollowingWatch::place_at(double t_s) const {
    return t_s <= move_s_ && before_.line > 0 ? before_ : move_.place;
}

double FollowingWatch::error_of(std::size_t axis, double joint_error) const {
    return report_.axes[axis].rotary ? joint_error / kRadPerDeg : joint_error;
}

// Integrates the square of an error by Simpson's rule: over a step it is smooth.
void FollowingWatch::look(double from_s, double to_s) {
    const rrs::JointPos from = motion_.errors(from_s);
    const rrs::JointPos middle = motion_.errors((from_s + to_s) / 2);
    const FollowingInstant to = motion_.at(to_s);
    for (std::size_t axis = 0; axis < squares_.size(); ++axis) {
        const auto joint = static_cast<Eigen::Index>(axis);
        squares_[axis].add((to_s - from_s) / 6 *
                           (from[joint] * from[joint] + 4 * middle[joint] * middle[joint] +
                            to.errors[joint] * to.errors[joint]));
        look_at_axis(axis, to_s, to.errors[joint]);
    }
    if ((is_rapid() ? rapid_ : feed_).is_paused()) look_at_tip(motion_.at(from_s));
    look_at_tip(to);
    if (is_rapid()) return;
    if (of_program_.is_paused()) look_at_program(motion_.at(from_s));
    look_at_program(to);
}

void FollowingWatch::look_at_axis(std::size_t axis, double t_s, double error) {
    const auto joint = static_cast<Eigen::Index>(axis);
    const auto size_at = [&](double at_s) { return std::abs(motion_.errors(at_s)[joint]); };
    if (!axes_[axis].add(t_s, std::abs(error), size_at)) return;
    AxisFollowing& told = report_.axes[axis];
    told.peak_t_s = axes_[axis].greatest_s();
    told.peak = error_of(axis, motion_.errors(told.peak_t_s)[joint]);
    told.peak_place = place_at(told.peak_t_s);
}

void FollowingWatch::look_at_tip(const FollowingInstant& instant) {
    if (!instant.contour_mm) {
        feed_.pause();
        rapid_.pause();
        return;
    }
    const bool rapid = is_rapid();
    PeakFinder& peak = rapid ? rapid_ : feed_;
    const auto error_at = [&](double at_s) { return motion_.at(at_s).contour_mm.value_or(0); };
    if (!peak.add(instant.t_s, *instant.contour_mm, error_at)) return;
    (rapid ? report_.rapid : report_.feed) = {peak.greatest(), peak.greatest_s(),
                                              place_at(peak.greatest_s())};
}

void FollowingWatch::look_at_program(const FollowingInstant& instant) {
    if (!instant.program_mm) return of_program_.pause();
    const auto error_at = [&](double at_s) { return motion_.at(at_s).program_mm.value_or(0); };
    if (!of_program_.add(instant.t_s, *instant.program_mm, error_at)) return;
    report_.program = {of_program_.greatest(), of_program_.greatest_s(), place_at(of_program_.greatest_s())};
}

void FollowingWatch::end(double end_s) {
    motion_.go_to(end_s, [this](double from_s, double to_s) { look(from_s, to_s); });
    const rrs::JointPos errors = motion_.errors(end_s);
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
        AxisFollowing& told = report_.axes[axis];
        told.end = error_of(axis, errors[static_cast<Eigen::Index>(axis)]);
        told.rms = end_s > 0 ? error_of(axis, std::sqrt(std::max(0.0, squares_[axis].value()) / end_s)) : 0;
    }
    report_.in_position_s.reset();
    if (const double settled = settled_s(end_s); motion_.in_bands(motion_.errors(motion_.now_s())))
        report_.in_position_s = settled;
}

/// Returns when the axes are in their bands to stay, as far as they are followed: s after the end.
double FollowingWatch::settled_s(double end_s) {
    constexpr int kHalvings = 40;
    double settled_s = end_s;
    const auto look = [&](double from_s, double to_s) {
        const auto in = [&](double t_s) { return motion_.in_bands(motion_.errors(t_s)); };
        if (!in(to_s)) {
            settled_s = to_s;
            return;
        }
        if (in(from_s)) return;
        double out_s = from_s, in_s = to_s;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle_s = (out_s + in_s) / 2;
            (in(middle_s) ? in_s : out_s) = middle_s;
        }
        settled_s = in_s;
    };
    motion_.go_to(end_s + motion_.longest_s(), look);
    return settled_s - end_s;
}

}  // namespace gsim::simulation
