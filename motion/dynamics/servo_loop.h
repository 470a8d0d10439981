#pragma once

#include <array>
#include <limits>

namespace gsim::dynamics {

/// The loop that a drive closes about a joint: a position loop in proportion to the error, with feed-forward,
/// around a velocity loop that is a lag of first order (Groß, Hamann, Wiegärtner: *Elektrische
/// Vorschubantriebe in der Automatisierungstechnik*, 2006, on position control in cascade; Weck, Brecher:
/// *Werkzeugmaschinen 3*, 2006, on the velocity gain Kv). Of a set point r and a place x:
///
///     v_command = gain (r - x) + velocity_share r' + acceleration_share lag r''
///     lag v' + v = v_command,    x' = v
///
/// Both shares at 1 undo gain and lag. What the loop gets, it gets `delay_s` late.
struct ServoLoop {
    double gain_1_s = std::numeric_limits<double>::infinity();  ///< 1 or greater; infinite: no error at all.
    double velocity_share = 0;
    double acceleration_share = 0;
    double lag_s = 0;
    double delay_s = 0;

    /// How long the joint is behind its set point at a speed that does not change.
    double behind_s() const { return (1 - velocity_share) / gain_1_s + delay_s; }
    /// The slowest part of an error dies away as exp(-slowest_1_s() t); infinite where there is none.
    double slowest_1_s() const;
};

/// The error of a loop, set point less place, and how fast it grows.
struct ServoError {
    double value = 0;
    double rate = 0;  ///< Part of the state with a lag; without one it follows from the error.
};

/// The speed of a set point over a step, as a polynomial of the time since its start: c0 + c1 t + c2 t^2 +
/// c3 t^3.
using SpeedPolynomial = std::array<double, 4>;

/// A loop over a step, without its delay: the error in closed form. With e = r - x it is
/// lag e'' + e' + gain e = (1 - velocity_share) r' + (1 - acceleration_share) lag r'': a polynomial, and what
/// is left of the start, which dies away.
class ServoStep {
  public:
    ServoStep() = default;
    ServoStep(const ServoLoop& loop, const SpeedPolynomial& speed, const ServoError& start);

    /// At a time since the start of the step.
    ServoError at(double t_s) const;
    /// What is left of the start, as an error: a bound of it from here on.
    double transient() const;

  private:
    ServoError decayed(double t_s) const;

    std::array<double, 4> forced_{};  // the polynomial
    ServoError left_;                 // at the start, of what dies away
    double gain_1_s_ = 0;             // 0: no error
    double lag_s_ = 0;
};

}  // namespace gsim::dynamics
