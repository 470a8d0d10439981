#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "cam/drawing/drawing.h"

namespace gsim::drawing {

/// Returns the contours in an SVG file: path, rect, circle, ellipse, line, polyline and polygon, in groups
/// and symbols, also by use; for all colours. It leaves out elements that are not displayed. Width and height
/// define the length of a unit; otherwise it is a px (1/96 inch). y is mirrored upwards, 0 at the lower edge
/// of the page. The error message begins with the line.
Result<Drawing> read_svg(std::string_view text, const ReadOptions& options);

}  // namespace gsim::drawing
