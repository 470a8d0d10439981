#pragma once

#include <cmath>
#include <numbers>
#include <random>

namespace gsim::batch {

/// Source of random numbers. Distributions differ between standard libraries; the functions below do not.
using Random = std::mt19937_64;

/// Returns a uniform number from 0 to below 1.
inline double uniform_random(Random& random) {
    constexpr double kSteps = 9007199254740992.0;  // 2^53
    return static_cast<double>(random() >> 11U) / kSteps;
}

/// Returns a normally distributed number with mean 0 and deviation 1 (Box and Muller 1958).
inline double normal_random(Random& random) {
    const double radius = std::sqrt(-2 * std::log(1 - uniform_random(random)));
    return radius * std::cos(2 * std::numbers::pi * uniform_random(random));
}

}  // namespace gsim::batch
