#include "tests/accuracy/controller.h"

#include <algorithm>
#include <cmath>

namespace gsim::accuracy {

namespace {

// Recorded times have whole ms: an error of just that many shall not fail for its binary digits.
constexpr double kRounding_s = 1e-9;

}  // namespace

bool Tolerance::holds(double error_s, double recorded_s) const {
    return std::abs(error_s) <= std::max(percent / 100 * recorded_s, least_s) + kRounding_s;
}

}  // namespace gsim::accuracy
