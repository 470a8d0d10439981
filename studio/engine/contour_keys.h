#pragma once

#include <array>
#include <optional>

#include "engine/drawing_path.h"
#include "studio/engine/keys.h"

namespace gsim::studio {

/// Directions that faces of a part may have.
inline constexpr std::array kContourSides{"x", "y", "z", "-x", "-y", "-z"};

/// Reads "contours" of a request, {"kind": "holes", "side": "z"}, if it exists.
void take_contours(Keys& keys, std::optional<engine::SurfaceChoice>& surface);

}  // namespace gsim::studio
