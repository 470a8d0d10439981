#pragma once

#include <numbers>

namespace gsim {

inline constexpr double kMmPerInch = 25.4;  // since 1959, by definition
inline constexpr double kRadPerDeg = std::numbers::pi / 180;
inline constexpr double kDegPerRad = 180 / std::numbers::pi;
inline constexpr double kTurn_rad = 2 * std::numbers::pi;
inline constexpr double kSecondsPerMinute = 60;
inline constexpr double kGramsPerKg = 1000;

}  // namespace gsim
