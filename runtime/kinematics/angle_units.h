#pragma once

#include <numbers>

namespace gsim::kinematics {

inline constexpr double kDegPerRad = 180 / std::numbers::pi;

}  // namespace gsim::kinematics
