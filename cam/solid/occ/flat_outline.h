#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <span>
#include <string>

#include "base/error.h"
#include "cam/solid/occ/shape_file.h"
#include "cam/solid/plate.h"

namespace gsim::solid {

/// Returns the outlines of surfaces that lie in one plane.
Result<Plate> plate_from_faces(std::span<const TopoDS_Face> faces, const ShapeFile& file,
                               const PlateOptions& options);

/// Returns curves that lie in one plane.
Result<Plate> plate_from_curves(std::span<const TopoDS_Edge> edges, const ShapeFile& file,
                                const PlateOptions& options);

}  // namespace gsim::solid
