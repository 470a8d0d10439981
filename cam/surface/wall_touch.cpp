#include "cam/surface/wall_touch.h"

#include <algorithm>

namespace gsim::surface {

namespace {

// The axis turns by at most half of the kerf over the wall's depth, so few steps are enough.
constexpr int kSteps = 6;

// From here on a jet touches both edges.
constexpr double kTakesNothing_mm = 0.03;

}  // namespace

Vector across(const Vector& direction, const Vector& axis) {
    return (direction - direction.dot(axis) * axis).normalized();
}

void touch_both(JetPoint& at, const JetShape& jet) {
    const Vector upper = at.aside;
    const Vector lower = at.low_aside;
    for (int i = 0; i < kSteps; ++i) {
        at.aside = across(upper, at.axis);
        at.low_aside = across(lower, at.axis);
        at.axis = (middle_of(at, jet) - at.low_mm - jet.kerf_mm / 2 * at.low_aside).normalized();
    }
    at.aside = across(upper, at.axis);
    at.low_aside = across(lower, at.axis);
}

void touch_twisted(JetPoint& at, const JetShape& jet) {
    const JetPoint along = at;
    const double cosine = across(at.aside, at.axis).dot(across(at.low_aside, at.axis));
    const double takes_mm = jet.kerf_mm / 2 * (1 - cosine);
    const double share = std::clamp((takes_mm - kMayTake_mm) / (kTakesNothing_mm - kMayTake_mm), 0.0, 1.0);
    touch_both(at, jet);
    at.axis = ((1 - share) * along.axis + share * at.axis).normalized();
    at.aside = across(along.aside, at.axis);
    at.low_aside = across(along.low_aside, at.axis);
}

void aim_low(JetPoint& at, const Vector& low_middle_mm, const JetShape& jet) {
    const Vector upper = at.aside;
    for (int i = 0; i < kSteps; ++i) {
        at.aside = across(upper, at.axis);
        at.axis = (middle_of(at, jet) - low_middle_mm).normalized();
    }
    at.low_aside = across(at.low_aside, at.axis);
    at.low_mm = low_middle_mm - jet.kerf_mm / 2 * at.low_aside;
}

}  // namespace gsim::surface
