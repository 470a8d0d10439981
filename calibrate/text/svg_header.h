#pragma once

#include <string>

namespace gsim::calibrate {

/// Returns the beginning of a picture (SVG) of this size, in pixels, up to its white background: small text
/// in a sans serif. "</svg>" ends it.
std::string svg_header(double width, double height);

}  // namespace gsim::calibrate
