#pragma once

#include <optional>
#include <string>

#include <pugixml.hpp>

#include "cam/drawing/pen.h"

namespace gsim::drawing {

/// Whether draw_svg_shape() knows elements of that name.
bool is_svg_shape(std::string_view name);

/// Draws a path, rect, circle, ellipse, line, polyline or polygon; the pen has been given where. What is
/// wrong is the end of a sentence.
std::optional<std::string> draw_svg_shape(const pugi::xml_node& node, Pen& pen);

/// Of an attribute that is a length; `otherwise` where there is none. Nothing where it cannot be read.
std::optional<double> length_attribute_px(const pugi::xml_node& node, const char* name, double otherwise);

}  // namespace gsim::drawing
