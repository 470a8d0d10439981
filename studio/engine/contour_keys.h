#pragma once

#include <array>
#include <optional>

#include "engine/drawing_path.h"
#include "studio/engine/key_reader.h"

namespace gsim::studio {

/// Directions that faces of a part may have.
inline constexpr std::array kViewDirections{"x", "y", "z", "-x", "-y", "-z"};

/// Reads "contours" of a request, {"kind": "holes", "side": "z"}, if it exists.
void unpack_contours(KeyReader& keys, std::optional<engine::SurfaceCuttingOptions>& surface);

}  // namespace gsim::studio
