#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cam/drawing/pen.h"

namespace gsim::drawing {

/// Draws the path data of SVG 1.1, 8.3: M L H V C S Q T A Z, absolute and relative. Returns an error as the
/// end of a message.
std::optional<std::string> draw_path_data(std::string_view data, Pen& pen);

}  // namespace gsim::drawing
