#pragma once

#include <limits>
#include <vector>

namespace gsim::dynamics {

/// Max effort of a motor, in both directions, N or Nm: linear between knots over its speed (mm/s or rad/s),
/// below the first one constant, beyond the last one 0.
class Motor {
  public:
    /// Creates no motor, or an unknown one.
    Motor() = default;
    /// Creates a motor with `peak` at most. The curve is empty or has as many speeds, each above the one
    /// before, as peaks.
    Motor(double peak, const std::vector<double>& speeds, const std::vector<double>& peaks);

    bool is_known() const { return !knots_.empty(); }
    /// Returns the speed beyond which it has no effort.
    double top_speed() const { return top_speed_; }
    /// Returns the min peak up to a speed.
    double least_peak(double speed) const;
    /// An effort of at_rest + linear u + square u^2. least_left() returns the min remainder of the peak over
    /// u from 0 to `most`, at the speed u `by_speed`.
    struct Effort {
        double at_rest = 0;
        double linear = 0;
        double square = 0;
    };
    double least_left(const Effort& effort, double by_speed, double most) const;

  private:
    struct Knot {
        double speed;
        double peak;
    };

    std::vector<Knot> knots_;  // the first at 0
    double top_speed_ = std::numeric_limits<double>::infinity();
};

}  // namespace gsim::dynamics
