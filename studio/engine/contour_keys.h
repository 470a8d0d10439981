#pragma once

#include <array>
#include <optional>

#include "engine/drawing_path.h"
#include "studio/engine/keys.h"

namespace gsim::studio {

/// Where faces of a part may look to.
inline constexpr std::array kContourSides{"x", "y", "z", "-x", "-y", "-z"};

/// Takes what "contours" of a request says, {"kind": "holes", "side": "z"}, where it is there.
void take_contours(Keys& keys, std::optional<engine::SurfaceChoice>& surface);

}  // namespace gsim::studio
