#pragma once

#include <numbers>

namespace gsim::motion {

inline constexpr double kRadPerDeg = std::numbers::pi / 180;
inline constexpr double kTurn_rad = 2 * std::numbers::pi;
inline constexpr double kSecondsPerMinute = 60;

}  // namespace gsim::motion
