#pragma once

#include <string>

#include "analysis/envelope/surface.h"

namespace gsim::envelope {

/// A surface as binary STL, in mm. Triangles without an area are left out where two of their corners are the
/// same in the file's single precision: the surface stays closed without them.
std::string to_stl(const Surface& surface);

}  // namespace gsim::envelope
