#pragma once

#include <cmath>

namespace gsim::motion {

inline double squared(double value) {
    return value * value;
}

/// Returns the root x >= 0 of x^2 + b x = c, for b and c >= 0, in the form without cancellation; infinite if
/// c is.
inline double positive_root(double b, double c) {
    if (std::isinf(c)) return c;
    const double twice = b + std::sqrt(b * b + 4 * c);
    return twice > 0 ? 2 * c / twice : 0;
}

}  // namespace gsim::motion
