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

    bool is_known() const { return !effort_curve_.empty(); }
    /// Returns the speed beyond which it has no effort.
    double top_speed() const { return top_speed_; }
    /// Returns the min peak up to a speed.
    double min_peak(double speed) const;
    /// An effort of at_standstill + linear u + quadratic u^2. min_reserve() returns the min remainder of the
    /// peak over u from 0 to `max`, at the speed u `speed_scale`.
    struct Effort {
        double at_standstill = 0;
        double linear = 0;
        double quadratic = 0;
    };
    double min_reserve(const Effort& effort, double speed_scale, double max) const;

  private:
    struct EffortPoint {
        double speed;
        double peak;
    };

    std::vector<EffortPoint> effort_curve_;  // the first at 0
    double top_speed_ = std::numeric_limits<double>::infinity();
};

}  // namespace gsim::dynamics
