#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

#include "base/error.h"
#include "geometry/mesh/mesh.h"

namespace gsim::solid {

/// Returns the faces of a shape as triangles with a deviation of at most `tolerance_mm`.
Result<Mesh> tessellate(const TopoDS_Shape& shape, double tolerance_mm);

}  // namespace gsim::solid
