#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace gsim::motion {

/// Where a motion is on its path at an instant: distance, speed, acceleration along it (mm or rad, s).
struct LawState {
    double s = 0;
    double v = 0;
    double a = 0;
};

/// One polynomial piece of a time law: s(t) = s0 + v0 t + a0 t^2/2 + j t^3/6 for t in [0, duration_s].
struct LawPiece {
    double duration_s;
    double s0;
    double v0;
    double a0;
    double jerk;
};

/// A path length as a function of time, made of polynomial pieces, so that it can be evaluated at any instant
/// and its duration comes from no sampling. Lengths are mm or rad, as the caller has it.
class TimeLaw {
  public:
    /// The law that stays at 0: length 0, duration 0.
    TimeLaw() = default;

    /// Rest to rest over `length` >= 0 in the least time: trapezoid, or triangle where `max_speed` is not
    /// reached. Equal acceleration and deceleration phases (thesis 5.3.2.1). Limits must be > 0; infinite
    /// acceleration gives the rectangle.
    static TimeLaw fastest(double length, double max_speed, double max_acceleration);

    /// The duration of fastest(), without the law.
    static double fastest_s(double length, double max_speed, double max_acceleration);

    /// Rest to rest over `length` in exactly `duration_s`, with ramps of `max_acceleration` and the cruise
    /// speed that results. `duration_s` must not be less than that of fastest(length, max_speed,
    /// max_acceleration); a shortfall within rounding is taken as equal. `max_speed` only keeps rounding from
    /// passing that speed.
    static TimeLaw in_time(double length, double duration_s, double max_acceleration,
                           double max_speed = std::numeric_limits<double>::infinity());

    double length() const { return length_; }
    double duration_s() const { return duration_s_; }
    /// The highest speed of the law.
    double peak_speed() const { return peak_speed_; }
    /// The state at `t_s`, clamped to [0, duration]; the end returns `length` exactly.
    LawState at(double t_s) const;

  private:
    TimeLaw(double length, double duration_s, double cruise_speed, double acceleration);

    void add_piece(double duration_s, double s0, double v0, double a0) {
        if (duration_s > 0) pieces_[count_++] = {duration_s, s0, v0, a0, 0};
    }

    static constexpr std::size_t kMaxPieces = 7;  // a jerk-limited ramp up, cruise and ramp down
    std::array<LawPiece, kMaxPieces> pieces_;     // only the first count_ hold values
    std::size_t count_ = 0;
    double length_ = 0;
    double duration_s_ = 0;
    double peak_speed_ = 0;
};

}  // namespace gsim::motion
