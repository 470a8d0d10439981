#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "cam/drawing/drawing.h"

namespace gsim::drawing {

/// The contours in an SVG file: path, rect, circle, ellipse, line, polyline and polygon, in groups and
/// symbols, also by use; whatever their colours. What is not displayed is left out. Width and height say how
/// long a unit is; where they do not, it is a px (1/96 inch). y is turned upwards, 0 at the lower edge of the
/// page. The error is a sentence that begins with the line.
tl::expected<Drawing, std::string> read_svg(std::string_view text, const ReadOptions& options);

}  // namespace gsim::drawing
