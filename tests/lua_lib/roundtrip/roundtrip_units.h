#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <numbers>

namespace gsim::roundtrip {

inline constexpr double kRadPerDeg = std::numbers::pi / 180;
inline constexpr double kNoMove_mm = 1e-7;
/// Words of the work offsets, in their order.
inline constexpr const char* kSystems[] = {"G54", "G55",   "G56",   "G57",  "G58",
                                           "G59", "G59.1", "G59.2", "G59.3"};

/// An index of Eigen's as one of the standard library's.
inline std::size_t at(Eigen::Index i) {
    return static_cast<std::size_t>(i);
}

}  // namespace gsim::roundtrip
