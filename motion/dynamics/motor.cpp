#include "motion/dynamics/motor.h"

#include <algorithm>
#include <cmath>

namespace gsim::dynamics {

namespace {

/// Returns the min of c0 + c1 u + c2 u^2 between two values.
double least_of(double c0, double c1, double c2, double from, double to) {
    const auto at = [&](double u) { return c0 + u * (c1 + u * c2); };
    double least = std::min(at(from), at(to));
    if (c2 <= 0) return least;
    const double bottom = -c1 / (2 * c2);
    if (bottom > from && bottom < to) least = std::min(least, at(bottom));
    return least;
}

}  // namespace

Motor::Motor(double peak, const std::vector<double>& speeds, const std::vector<double>& peaks) {
    if (speeds.empty()) {
        if (std::isfinite(peak)) knots_.push_back({0, peak});
        return;
    }
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        if (i > 0 &&
            (peaks[i - 1] > peak) != (peaks[i] > peak)) {  // point at which the curve crosses the peak
            const double share = (peak - peaks[i - 1]) / (peaks[i] - peaks[i - 1]);
            if (share > 0 && share < 1) knots_.push_back({std::lerp(speeds[i - 1], speeds[i], share), peak});
        }
        knots_.push_back({speeds[i], std::min(peak, peaks[i])});
    }
    if (knots_.front().speed > 0) knots_.insert(knots_.begin(), {0, knots_.front().peak});
    top_speed_ = speeds.back();
}

double Motor::least_peak(double speed) const {
    return least_left({}, speed, 1);
}

double Motor::least_left(const Effort& effort, double by_speed, double most) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        const Knot& knot = knots_[i];
        const bool last = i + 1 == knots_.size();
        const double from = knot.speed > 0 ? std::min(knot.speed / by_speed, most) : 0;
        const double to = last ? most : std::min(knots_[i + 1].speed / by_speed, most);
        const double slope = last ? 0 : (knots_[i + 1].peak - knot.peak) / (knots_[i + 1].speed - knot.speed);
        least = std::min(least, least_of(knot.peak - slope * knot.speed - effort.at_rest,
                                         slope * by_speed - effort.linear, -effort.square, from, to));
        if (to >= most) break;
    }
    return least;
}

}  // namespace gsim::dynamics
