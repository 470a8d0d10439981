#pragma once

#include <string>

#include "analysis/envelope/surface.h"

namespace gsim::envelope {

/// Returns a surface as binary STL, in mm. Triangles without an area are omitted if two of their corners are
/// the same in the file's single precision: the surface stays closed without them.
std::string to_stl(const Surface& surface);

}  // namespace gsim::envelope
