#pragma once

#include <limits>
#include <vector>

namespace gsim::dynamics {

/// What a motor brings up, either way, N or Nm: straight between knots over its speed (mm/s or rad/s), below
/// the first as there, beyond the last one nothing.
class Motor {
  public:
    /// No motor, or none that is known.
    Motor() = default;
    /// `peak` at most; with a curve, which is empty or as many speeds, each above the one before, as peaks.
    Motor(double peak, const std::vector<double>& speeds, const std::vector<double>& peaks);

    bool is_known() const { return !knots_.empty(); }
    /// Beyond this it brings up nothing.
    double top_speed() const { return top_speed_; }
    /// The least up to a speed.
    double least_peak(double speed) const;
    /// The least over u from 0 to `most` of what is left at the speed u `by_speed` beside an effort of
    /// at_rest + linear u + square u^2.
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
