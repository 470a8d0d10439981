#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

#include <tl/expected.hpp>

#include "geometry/mesh/mesh.h"

namespace gsim::solid {

/// Returns the faces of a shape as triangles with a deviation of at most `tolerance_mm`. The error is a
/// message.
tl::expected<Mesh, std::string> tessellate(const TopoDS_Shape& shape, double tolerance_mm);

}  // namespace gsim::solid
