#pragma once

#include <array>
#include <limits>

namespace gsim::dynamics {

/// The loop that a drive closes about a joint: a position loop in proportion to the error, with feed-forward,
/// around a velocity loop that is a lag of first order (Groß, Hamann, Wiegärtner: *Elektrische
/// Vorschubantriebe in der Automatisierungstechnik*, 2006, on position control in cascade; Weck, Brecher:
/// *Werkzeugmaschinen 3*, 2006, on the velocity gain Kv). With a set point r and a position x:
///
///     v_command = gain (r - x) + velocity_share r' + acceleration_share lag r''
///     lag v' + v = v_command,    x' = v
///
/// Both shares at 1 compensate gain and lag. All inputs of the loop are late by `delay_s`.
struct ServoLoop {
    double gain_1_s = std::numeric_limits<double>::infinity();  ///< 1 or greater; infinite: no error at all.
    double velocity_share = 0;
    double acceleration_share = 0;
    double lag_s = 0;
    double delay_s = 0;

    /// Returns how far the joint lags behind its set point, as a time, at a constant speed.
    double constant_speed_lag_s() const { return (1 - velocity_share) / gain_1_s + delay_s; }
    /// Returns the decay rate of the slowest part of an error, which decays as exp(-slowest_1_s() t);
    /// infinite if no such part exists.
    double slowest_1_s() const;
};

/// The error of a loop, set point minus position, and its rate of growth.
struct ServoError {
    double value = 0;
    double rate = 0;  ///< Part of the state with a lag; without one it follows from the error.
};

/// The speed of a set point over a step, as a polynomial of the time since its start: c0 + c1 t + c2 t^2 +
/// c3 t^3.
using SpeedPolynomial = std::array<double, 4>;

/// A loop over a step, without its delay: the error in closed form. With e = r - x it is lag e'' + e' + gain
/// e = (1 - velocity_share) r' + (1 - acceleration_share) lag r'': a polynomial, and the remainder of the
/// start, which decays.
class ServoStep {
  public:
    ServoStep() = default;
    ServoStep(const ServoLoop& loop, const SpeedPolynomial& speed, const ServoError& start);

    /// Returns the error at a time since the start of the step.
    ServoError at(double t_s) const;
    /// Returns the remainder of the start, as an error: a bound of it from here on.
    double transient_bound() const;

  private:
    ServoError transient_at(double t_s) const;

    std::array<double, 4> forced_response_{};  // the polynomial
    ServoError transient_;                     // at the start, of what dies away
    double gain_1_s_ = 0;                      // 0: no error
    double lag_s_ = 0;
};

}  // namespace gsim::dynamics
