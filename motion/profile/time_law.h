#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "motion/profile/s_curve.h"

namespace gsim::motion {

/// State of a motion on its path at an instant: distance, speed, acceleration along it (mm or rad, s).
struct LawState {
    double s = 0;
    double v = 0;
    double a = 0;
};

/// One polynomial part of a time law: s(t) = s0 + v0 t + a0 t^2/2 + j t^3/6 for t in [0, duration_s].
struct LawSection {
    double duration_s;
    double s0;
    double v0;
    double a0;
    double jerk;
};

/// Path length as a function of time, made of polynomial parts. It can be evaluated at any instant, and its
/// duration does not come from sampling. Lengths are mm or rad, as the caller chooses.
class TimeLaw {
  public:
    /// Makes the law that stays at 0: length 0, duration 0.
    TimeLaw() = default;

    /// Returns the law from standstill to standstill over `length` >= 0 in the least time: trapezoid, or
    /// triangle if `max_speed` is not reached. Acceleration and deceleration phases are equal (thesis
    /// 5.3.2.1). Limits must be > 0; infinite acceleration gives the rectangle.
    static TimeLaw fastest(double length, double max_speed, double max_acceleration);

    /// Returns the duration of fastest(), without the law.
    static double fastest_s(double length, double max_speed, double max_acceleration);

    /// Returns the law from standstill to standstill over `length` in exactly `duration_s`, with ramps of
    /// `max_acceleration` and the resulting cruise speed. `duration_s` must not be less than that of
    /// fastest(length, max_speed, max_acceleration); a shortfall within rounding is taken as equal.
    /// `max_speed` only keeps rounding from passing that speed.
    static TimeLaw with_duration(double length, double duration_s, double max_acceleration,
                                 double max_speed = std::numeric_limits<double>::infinity());

    /// Returns the law from standstill to standstill over `length` > 0 in exactly `duration_s`, with the
    /// ramps of `limits` and the resulting cruise speed. `duration_s` must not be less than that of
    /// between(length, 0, 0, limits); a shortfall within rounding is taken as equal.
    static TimeLaw with_duration(double length, double duration_s, const LawLimits& limits);

    /// Returns the law of least time over `length` >= 0 from start_speed to end_speed, both >= 0, with
    /// acceleration 0 at both ends if the jerk is finite. A start_speed above max_speed is braked first, with
    /// the deceleration. The length must suffice for the ramp between both speeds (reachable_speed()). A
    /// shortfall is compensated by doing that ramp in less time, with the speeds unchanged: one of rounding
    /// costs the limits no more than rounding. A path without length takes no time, for any speeds.
    static TimeLaw between(double length, double start_speed, double end_speed, const LawLimits& limits);

    /// Returns the law made of `sections`, at most kMaxSections of them. They must begin at s0 = 0, each at
    /// the end of the one before it, and must not run backwards. Parts without duration are left out.
    static TimeLaw from_sections(std::span<const LawSection> sections);

    static constexpr std::size_t kMaxSections =
        9;  ///< Two jerk-limited ramps, a cruise and a dwell at each end.

    double length() const { return length_; }
    double duration_s() const { return duration_s_; }
    /// Returns the highest speed of the law.
    double peak_speed() const { return peak_speed_; }
    /// Returns the highest acceleration or deceleration of the law, not counting jumps of the speed.
    double peak_acceleration() const;
    /// Returns the speed with which the law starts, or ends. The speed jumps at the ends if the acceleration
    /// is unlimited, and at() returns the one inside.
    double start_speed() const { return start_speed_; }
    double end_speed() const { return end_speed_; }
    /// True if the speed jumps at an end, because the acceleration is unlimited.
    bool jumps() const;
    std::span<const LawSection> sections() const { return {sections_.data(), count_}; }
    /// Returns the state at `t_s`, clamped to [0, duration]; the end returns `length` exactly.
    LawState at(double t_s) const;

  private:
    TimeLaw(double length, double duration_s, double cruise_speed, double acceleration);

    void add_section(double duration_s, double s0, double v0, double a0, double jerk = 0) {
        if (duration_s > 0) sections_[count_++] = {duration_s, s0, v0, a0, jerk};
    }
    void add_ramp(double from_speed, double change, double to_speed, const LawLimits& limits, double& s);
    void fit_length(double reached);
    void advance(double duration_s);

    std::array<LawSection, kMaxSections> sections_;  // only the first count_ hold values
    std::size_t count_ = 0;
    double length_ = 0;
    double duration_s_ = 0;
    double peak_speed_ = 0;
    double start_speed_ = 0;
    double end_speed_ = 0;
};

}  // namespace gsim::motion
