#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

#include <tl/expected.hpp>

#include "geometry/mesh/mesh.h"

namespace gsim::solid {

/// The faces of a shape in triangles, off them by `tolerance_mm` at most. The error is a sentence.
tl::expected<Mesh, std::string> tessellate(const TopoDS_Shape& shape, double tolerance_mm);

}  // namespace gsim::solid
