#pragma once

#include <optional>
#include <string>

#include <pugixml.hpp>

#include "base/error.h"
#include "cam/drawing/pen.h"

namespace gsim::drawing {

/// Returns true if draw_svg_shape() supports elements of that name.
bool is_svg_shape(std::string_view name);

/// Draws a path, rect, circle, ellipse, line, polyline or polygon at the target set in the pen. Returns an
/// error as the end of a message.
Result<void> draw_svg_shape(const pugi::xml_node& node, Pen& pen);

/// Returns the value of a length attribute; `fallback` if it is missing. Returns nothing if it cannot be
/// read.
std::optional<double> length_attribute_px(const pugi::xml_node& node, const char* name, double fallback);

}  // namespace gsim::drawing
