#include "motion/profile/time_law.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/profile/ramp.h"

namespace gsim::motion {

namespace {

LawState state_at(const LawSection& section, double t) {
    return {section.s0 + t * (section.v0 + t * (section.a0 / 2 + t * section.jerk / 6)),
            section.v0 + t * (section.a0 + t * section.jerk / 2), section.a0 + t * section.jerk};
}

double peak_speed_of(const LawSection& section) {
    const double ends = std::max(section.v0, state_at(section, section.duration_s).v);
    const double turn_s = -section.a0 / section.jerk;
    if (!(turn_s > 0 && turn_s < section.duration_s)) return ends;
    return std::max(ends, state_at(section, turn_s).v);
}

// Returns the cruise speed of a motion from standstill to standstill in a given time. Newton's method finds
// the lower root of length + speed (time of both ramps) / 2 = speed duration, which has a convex left side.
// The steps from below never pass the root, and the first one without gain is rounding.
double cruise_speed(double length, double duration_s, const LawLimits& limits) {
    constexpr int kMaxIterations = 60;
    double speed = length / duration_s;
    for (int i = 0; i < kMaxIterations; ++i) {
        double ramps_s = 0;
        double slope_s = 0;  // of speed (time of both ramps)
        for (const double acceleration : {limits.acceleration, limits.deceleration}) {
            const RampPhases ramp = ramp_phases(speed, acceleration, limits.jerk);
            ramps_s += ramp.duration_s();
            slope_s += ramp.duration_s();
            if (ramp.duration_s() > 0) slope_s += speed / ramp.acceleration;
        }
        const double missing = length + speed * (ramps_s / 2 - duration_s);
        const double next = speed + missing / (duration_s - slope_s / 2);
        if (!(slope_s / 2 < duration_s) || !(next > speed)) break;
        speed = next;
    }
    return speed;
}

}  // namespace

double TimeLaw::fastest_s(double length, double max_speed, double max_acceleration) {
    if (length <= 0) return 0;
    const double ramp_s = max_speed / max_acceleration;
    if (std::isfinite(max_speed) && max_speed * ramp_s <= length) return length / max_speed + ramp_s;
    return 2 * std::sqrt(length / max_acceleration);
}

TimeLaw TimeLaw::fastest(double length, double max_speed, double max_acceleration) {
    const double duration_s = fastest_s(length, max_speed, max_acceleration);
    const double top = std::sqrt(length * max_acceleration);  // of the triangle
    return {length, duration_s, duration_s > 0 ? std::min(top, max_speed) : 0, max_acceleration};
}

// The cruise speed v solves length = v duration - v^2 / acceleration; this form of the root has no
// cancellation. Rounding may lift v by the square root of an epsilon if the root is nearly double (a
// triangle). The length then depends on v only in the second order, so holding it to max_speed costs nothing.
TimeLaw TimeLaw::with_duration(double length, double duration_s, double max_acceleration, double max_speed) {
    if (!(duration_s > 0)) return {length, 0, 0, max_acceleration};
    const double square = 1 - 4 * length / max_acceleration / (duration_s * duration_s);
    const double speed = 2 * length / (duration_s * (1 + std::sqrt(std::max(0.0, square))));
    return {length, duration_s, std::min(speed, max_speed), max_acceleration};
}

TimeLaw TimeLaw::with_duration(double length, double duration_s, const LawLimits& limits) {
    LawLimits slower = limits;
    slower.max_speed = std::min(cruise_speed(length, duration_s, limits), limits.max_speed);
    TimeLaw law = between(length, 0, 0, slower);
    law.advance(duration_s);
    return law;
}

TimeLaw::TimeLaw(double length, double duration_s, double cruise_speed, double acceleration)
    : length_(length), duration_s_(duration_s), peak_speed_(cruise_speed) {
    double ramp_s = std::min(cruise_speed / acceleration, duration_s / 2);
    double ramp_acceleration = cruise_speed / ramp_s;
    if (!std::isfinite(ramp_acceleration)) ramp_s = ramp_acceleration = 0;  // the rectangle
    const double ramp_length = cruise_speed * ramp_s / 2;
    add_section(ramp_s, 0, 0, ramp_acceleration);
    add_section(duration_s - 2 * ramp_s, ramp_length, cruise_speed, 0);
    add_section(ramp_s, length - ramp_length, cruise_speed, -ramp_acceleration);
}

TimeLaw TimeLaw::between(double length, double start_speed, double end_speed, const LawLimits& limits) {
    TimeLaw law;
    law.start_speed_ = start_speed;
    law.end_speed_ = end_speed;
    law.peak_speed_ = std::max(start_speed, end_speed);
    if (!(length > 0)) return law;
    law.length_ = length;
    const SpeedShape shape = fastest_shape(length, start_speed, end_speed, limits);
    if (!std::isfinite(shape.cruise_speed)) return law;  // no limit applies
    law.peak_speed_ = std::max(law.peak_speed_, shape.cruise_speed);
    double s = 0;
    law.add_ramp(start_speed, shape.first_change, shape.cruise_speed, limits, s);
    law.add_section(shape.cruise_length / shape.cruise_speed, s, shape.cruise_speed, 0);
    s += shape.cruise_length;
    law.add_ramp(shape.cruise_speed, shape.second_change, end_speed, limits, s);
    law.fit_length(s);
    return law;
}

TimeLaw TimeLaw::from_sections(std::span<const LawSection> sections) {
    assert(sections.size() <= kMaxSections);
    TimeLaw law;
    for (const LawSection& section : sections.first(std::min(sections.size(), kMaxSections))) {
        if (!(section.duration_s > 0)) continue;
        law.add_section(section.duration_s, section.s0, section.v0, section.a0, section.jerk);
        law.start_speed_ = law.sections_[0].v0;
        const LawState end = state_at(section, section.duration_s);
        law.duration_s_ += section.duration_s;
        law.length_ = end.s;
        law.end_speed_ = std::max(end.v, 0.0);
        law.peak_speed_ = std::max(law.peak_speed_, peak_speed_of(section));
    }
    return law;
}

// Adds a ramp from `s` on, and moves `s` on. Speeds are counted from the nearer end of the ramp, so that both
// ends are met without rounding.
void TimeLaw::add_ramp(double from_speed, double change, double to_speed, const LawLimits& limits,
                       double& s) {
    const double sign = change < 0 ? -1 : 1;
    const double limit = change < 0 ? limits.deceleration : limits.acceleration;
    const RampPhases ramp = ramp_phases(std::abs(change), limit, limits.jerk);
    const double acceleration = sign * ramp.acceleration;
    const double jerk = ramp.jerk_s > 0 ? sign * limits.jerk : 0;
    const double speed_change = acceleration * ramp.jerk_s / 2;  // change of speed in a phase of jerk
    add_section(ramp.jerk_s, s, from_speed, 0, jerk);
    s += ramp.jerk_s * (from_speed + speed_change / 3);
    add_section(ramp.constant_s, s, from_speed + speed_change, acceleration);
    s += ramp.constant_s * (from_speed + speed_change + acceleration * ramp.constant_s / 2);
    add_section(ramp.jerk_s, s, to_speed - speed_change, acceleration, -jerk);
    s += ramp.jerk_s * (to_speed - speed_change / 3);
}

// Makes parts that reach `reached` reach length_ by running time faster or slower; the speeds are kept.
void TimeLaw::fit_length(double reached) {
    if (!(reached > 0)) {  // not of valid limits and speeds
        count_ = 0;
        return;
    }
    const double factor = length_ / reached;
    for (std::size_t i = 0; i < count_; ++i) {
        LawSection& section = sections_[i];
        section.duration_s *= factor;
        section.s0 *= factor;
        section.a0 /= factor;
        section.jerk /= factor * factor;
        duration_s_ += section.duration_s;
    }
}

// Runs time faster or slower; the length is kept.
void TimeLaw::advance(double duration_s) {
    if (!(duration_s_ > 0)) return;
    const double factor = duration_s / duration_s_;
    for (std::size_t i = 0; i < count_; ++i) {
        LawSection& section = sections_[i];
        section.duration_s *= factor;
        section.v0 /= factor;
        section.a0 /= factor * factor;
        section.jerk /= factor * factor * factor;
    }
    peak_speed_ /= factor;
    duration_s_ = duration_s;
}

bool TimeLaw::jumps() const {
    constexpr double kEqualTolerance = 1e-9;  // of the peak speed
    if (count_ == 0) return start_speed_ != end_speed_;
    const LawSection& last = sections_[count_ - 1];
    const double start_jump = std::abs(sections_[0].v0 - start_speed_);
    const double end_jump = std::abs(state_at(last, last.duration_s).v - end_speed_);
    return std::max(start_jump, end_jump) > kEqualTolerance * peak_speed_;
}

double TimeLaw::peak_acceleration() const {
    double peak = 0;
    for (const LawSection& section : sections()) {
        peak =
            std::max({peak, std::abs(section.a0), std::abs(section.a0 + section.duration_s * section.jerk)});
    }
    return peak;
}

LawState TimeLaw::at(double t_s) const {
    if (count_ == 0) return {length_, end_speed_, 0};
    double t = t_s;
    std::size_t index = 0;
    const bool over = t_s >= duration_s_;
    while (index + 1 < count_ && (over || t > sections_[index].duration_s))
        t -= sections_[index++].duration_s;
    const LawSection& section = sections_[index];
    // The last part is counted from the end, so that it stops exactly, however long the others are.
    if (index + 1 == count_) t = section.duration_s - (duration_s_ - t_s);
    t = std::clamp(t, 0.0, section.duration_s);
    const LawState state = state_at(section, t);
    // A path is never run backwards: a negative speed at the end is rounding.
    return {over ? length_ : std::clamp(state.s, 0.0, length_), std::max(state.v, 0.0), state.a};
}

}  // namespace gsim::motion
