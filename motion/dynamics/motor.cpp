#include "motion/dynamics/motor.h"

#include <algorithm>
#include <cmath>

namespace gsim::dynamics {

namespace {

/// Returns the min of c0 + c1 u + c2 u^2 between two values.
double min_quadratic(double c0, double c1, double c2, double from, double to) {
    const auto at = [&](double u) { return c0 + u * (c1 + u * c2); };
    double min = std::min(at(from), at(to));
    if (c2 <= 0) return min;
    const double bottom = -c1 / (2 * c2);
    if (bottom > from && bottom < to) min = std::min(min, at(bottom));
    return min;
}

}  // namespace

Motor::Motor(double peak, const std::vector<double>& speeds, const std::vector<double>& peaks) {
    if (speeds.empty()) {
        if (std::isfinite(peak)) effort_curve_.push_back({0, peak});
        return;
    }
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        if (i > 0 &&
            (peaks[i - 1] > peak) != (peaks[i] > peak)) {  // the point where the curve crosses the peak
            const double share = (peak - peaks[i - 1]) / (peaks[i] - peaks[i - 1]);
            if (share > 0 && share < 1)
                effort_curve_.push_back({std::lerp(speeds[i - 1], speeds[i], share), peak});
        }
        effort_curve_.push_back({speeds[i], std::min(peak, peaks[i])});
    }
    if (effort_curve_.front().speed > 0)
        effort_curve_.insert(effort_curve_.begin(), {0, effort_curve_.front().peak});
    top_speed_ = speeds.back();
}

double Motor::min_peak(double speed) const {
    return min_reserve({}, speed, 1);
}

double Motor::min_reserve(const Effort& effort, double speed_scale, double max) const {
    double min = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < effort_curve_.size(); ++i) {
        const EffortPoint& curve_point = effort_curve_[i];
        const bool last = i + 1 == effort_curve_.size();
        const double from = curve_point.speed > 0 ? std::min(curve_point.speed / speed_scale, max) : 0;
        const double to = last ? max : std::min(effort_curve_[i + 1].speed / speed_scale, max);
        const double slope = last ? 0
                                  : (effort_curve_[i + 1].peak - curve_point.peak) /
                                        (effort_curve_[i + 1].speed - curve_point.speed);
        min = std::min(min, min_quadratic(curve_point.peak - slope * curve_point.speed - effort.at_standstill,
                                          slope * speed_scale - effort.linear, -effort.quadratic, from, to));
        if (to >= max) break;
    }
    return min;
}

}  // namespace gsim::dynamics
