#include "motion/profile/law_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/profile/ramp.h"

namespace gsim::motion {

namespace {

constexpr double kLengthRounding = 1e-12;
constexpr double kAccelerationRounding = 1e-9;  // relative to the ramp's

/// Collector of consecutive law parts.
class LawBuilder {
  public:
    void add(double duration_s, double v0, double a0, double jerk) {
        if (!(duration_s > 0) || count_ == sections_.size()) return;
        sections_[count_++] = {duration_s, s_, v0, a0, jerk};
        s_ += duration_s * (v0 + duration_s * (a0 / 2 + duration_s * jerk / 6));
    }
    void add(const TimeLaw& law) {
        for (const LawSection& section : law.sections())
            add(section.duration_s, section.v0, section.a0, section.jerk);
    }
    double length() const { return s_; }
    TimeLaw law() const { return TimeLaw::from_sections(std::span(sections_.data(), count_)); }

  private:
    std::array<LawSection, TimeLaw::kMaxSections> sections_;
    std::size_t count_ = 0;
    double s_ = 0;
};

/// Returns the rest of a part from `t_s` on.
LawSection section_remainder(const LawSection& section, double t_s) {
    return {section.duration_s - t_s, 0, section.v0 + t_s * (section.a0 + t_s * section.jerk / 2),
            section.a0 + t_s * section.jerk, section.jerk};
}

double end_speed(const LawSection& section) {
    return std::max(section_remainder(section, section.duration_s).v0, 0.0);
}

/// Adds the parts of the active ramp from `t_s` on, until the acceleration is 0; returns the speed there.
double finish_ramp(const TimeLaw& law, double t_s, LawBuilder& sections) {
    double speed = law.at(t_s).v;
    for (const LawSection& section : law.sections()) {
        if (t_s >= section.duration_s) {
            t_s -= section.duration_s;
            continue;
        }
        const LawSection remainder = section_remainder(section, t_s);
        t_s = 0;
        const bool is_braking = remainder.a0 + remainder.jerk * remainder.duration_s / 2 < 0;
        if (!is_braking) break;
        sections.add(remainder.duration_s, remainder.v0, remainder.a0, remainder.jerk);
        speed = end_speed(remainder);
        const double last = remainder.a0 + remainder.jerk * remainder.duration_s;
        if (last >= kAccelerationRounding * std::min(remainder.a0, last)) break;
    }
    return speed;
}

/// Takes the acceleration at an instant to 0 and returns the remaining speed.
double end_acceleration(const TimeLaw& law, double t_s, const LawLimits& limits, LawBuilder& sections) {
    const LawState state = law.at(t_s);
    if (std::isinf(limits.jerk)) return state.v;
    if (state.a < 0) return finish_ramp(law, t_s, sections);
    const double duration_s = state.a / limits.jerk;
    sections.add(duration_s, state.v, state.a, -limits.jerk);
    return state.v + state.a * duration_s / 2;
}

/// Returns the lowest speed at the end of `length`, if it is too short for a stop. Lengths of ramps down grow
/// with the change up to two thirds of the speed, or, if they hold their acceleration, up to acceleration^2 /
/// (2 jerk) above standstill.
double lowest_end_speed(double length, double speed, const LawLimits& limits) {
    double low = std::min(speed / 3, limits.deceleration * limits.deceleration / (2 * limits.jerk));
    double high = speed;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (ramp_length(speed, middle, limits.deceleration, limits.jerk) > length ? low : high) = middle;
    }
    return high;
}

}  // namespace

TimeLaw law_until(const TimeLaw& law, double t_s) {
    LawBuilder sections;
    for (const LawSection& section : law.sections()) {
        const double duration_s = std::min(section.duration_s, t_s);
        sections.add(duration_s, section.v0, section.a0, section.jerk);
        t_s -= duration_s;
    }
    return sections.law();
}

TimeLaw law_from(const TimeLaw& law, double t_s) {
    LawBuilder sections;
    for (const LawSection& section : law.sections()) {
        const double done_s = std::min(section.duration_s, t_s);
        const LawSection remainder = section_remainder(section, done_s);
        sections.add(remainder.duration_s, remainder.v0, remainder.a0, remainder.jerk);
        t_s -= done_s;
    }
    return sections.law();
}

TimeLaw extend_with_standstill(const TimeLaw& law, double duration_s) {
    LawBuilder sections;
    sections.add(law);
    sections.add(duration_s - law.duration_s(), 0, 0, 0);
    return sections.law();
}

TimeLaw braking_law(double length, double start_speed, double end_speed, const LawLimits& limits) {
    if (!(length > 0) || !(start_speed > 0)) return {};
    LawLimits is_braking = limits;
    is_braking.max_speed = start_speed;
    const double stop = ramp_length(start_speed, 0, limits.deceleration, limits.jerk);
    if (stop <= length * (1 + kLengthRounding))
        return stop > 0 ? TimeLaw::between(std::min(stop, length), start_speed, 0, is_braking) : TimeLaw();
    const double lowest = std::min(lowest_end_speed(length, start_speed, limits), end_speed);
    return TimeLaw::between(length, start_speed, lowest, is_braking);
}

TimeLaw braking_law(const TimeLaw& law, double t_s, const LawLimits& limits) {
    LawBuilder sections;
    const double remaining = law.length() - law.at(t_s).s;
    const double speed = end_acceleration(law, t_s, limits, sections);
    const double remainder = remaining - sections.length();
    if (remainder > kLengthRounding * law.length())
        sections.add(braking_law(remainder, speed, law.end_speed(), limits));
    return sections.law();
}

}  // namespace gsim::motion
