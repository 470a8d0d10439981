#pragma once

#include <array>
#include <string_view>

#include "controller/services/types.h"

namespace gsim::machine {

/// A direction along one of the axes of a frame, or a turn about it by the right-hand rule.
enum class AxisDirection { x, y, z, minus_x, minus_y, minus_z };

/// Names in machine files, in the order of AxisDirection.
inline constexpr std::array<std::string_view, 6> kDirectionNames{"x", "y", "z", "-x", "-y", "-z"};

std::string_view name(AxisDirection direction);
AxisDirection opposite(AxisDirection direction);

/// Returns a frame at the same position with Z along `direction`.
rrs::CartPos rotation_to(AxisDirection direction);

}  // namespace gsim::machine
