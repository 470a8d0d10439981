#include "cam/surface/wall_alignment.h"

#include <algorithm>

namespace gsim::surface {

namespace {

// The axis turns by at most half of the kerf over the wall's depth, so few steps are enough.
constexpr int kSteps = 6;

// From here on a jet touches both edges.
constexpr double kBlendEnd_mm = 0.03;

}  // namespace

Vector perpendicular(const Vector& direction, const Vector& axis) {
    return (direction - direction.dot(axis) * axis).normalized();
}

void align_to_both_edges(JetPoint& at, const JetShape& jet) {
    const Vector upper = at.lateral;
    const Vector lower = at.lower_offset_direction;
    for (int i = 0; i < kSteps; ++i) {
        at.lateral = perpendicular(upper, at.axis);
        at.lower_offset_direction = perpendicular(lower, at.axis);
        at.axis =
            (jet_center(at, jet) - at.low_mm - jet.kerf_mm / 2 * at.lower_offset_direction).normalized();
    }
    at.lateral = perpendicular(upper, at.axis);
    at.lower_offset_direction = perpendicular(lower, at.axis);
}

void align_to_twisted_wall(JetPoint& at, const JetShape& jet) {
    const JetPoint aligned_point = at;
    const double cosine =
        perpendicular(at.lateral, at.axis).dot(perpendicular(at.lower_offset_direction, at.axis));
    const double gouge_mm = jet.kerf_mm / 2 * (1 - cosine);
    const double share =
        std::clamp((gouge_mm - kAllowedGouge_mm) / (kBlendEnd_mm - kAllowedGouge_mm), 0.0, 1.0);
    align_to_both_edges(at, jet);
    at.axis = ((1 - share) * aligned_point.axis + share * at.axis).normalized();
    at.lateral = perpendicular(aligned_point.lateral, at.axis);
    at.lower_offset_direction = perpendicular(aligned_point.lower_offset_direction, at.axis);
}

void aim_lower_end(JetPoint& at, const Vector& lower_center_mm, const JetShape& jet) {
    const Vector upper = at.lateral;
    for (int i = 0; i < kSteps; ++i) {
        at.lateral = perpendicular(upper, at.axis);
        at.axis = (jet_center(at, jet) - lower_center_mm).normalized();
    }
    at.lower_offset_direction = perpendicular(at.lower_offset_direction, at.axis);
    at.low_mm = lower_center_mm - jet.kerf_mm / 2 * at.lower_offset_direction;
}

}  // namespace gsim::surface
