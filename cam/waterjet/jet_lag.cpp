#include "cam/waterjet/jet_lag.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace gsim::waterjet {

double lag_mm(const LagRule& rule, const StraightCut& cut, double speed_mm_min) {
    return rule.lag_to_thickness * cut.thickness_mm *
           std::pow(speed_mm_min / cut.separation_speed_mm_min, rule.exponent);
}

double speed_for_lag_mm_min(const LagRule& rule, const StraightCut& cut, double lag_mm) {
    return cut.separation_speed_mm_min *
           std::pow(lag_mm / (rule.lag_to_thickness * cut.thickness_mm), 1 / rule.exponent);
}

double contour_error_mm(const LagRule& rule, double quality) {
    const auto& errors = rule.contour_error_mm;
    const double sample_rank = std::clamp(quality, 1.0, static_cast<double>(errors.size())) - 1;
    const auto below = std::min(static_cast<std::size_t>(sample_rank), errors.size() - 2);
    return std::lerp(errors[below], errors[below + 1], sample_rank - static_cast<double>(below));
}

double lag_allowed_on_arc_mm(double radius_mm, double error_mm) {
    return std::sqrt(error_mm * (2 * radius_mm + error_mm));
}

double lag_allowed_in_corner_mm(double turn_rad, double error_mm) {
    const double share = std::sin(std::fmin(std::abs(turn_rad), std::numbers::pi) / 2);
    return share > 0 ? error_mm / share : std::numeric_limits<double>::infinity();
}

}  // namespace gsim::waterjet
