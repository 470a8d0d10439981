#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "cam/drawing/pen.h"

namespace gsim::drawing {

/// Draws the path data of SVG 1.1, 8.3: M L H V C S Q T A Z, absolute and relative. Returns an error as the
/// end of a message.
Result<void> draw_path_data(std::string_view data, Pen& pen);

}  // namespace gsim::drawing
