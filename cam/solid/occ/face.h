#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>
#include <gp_Pln.hxx>
#include <optional>
#include <string>

#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// "conical"
std::string kind_of(const TopoDS_Face& face);
/// The middle of one of its edges.
gp_Pnt place_of(const TopoDS_Face& face);
/// "the conical face #57 at (1, 2, 3)"
std::string shown(const TopoDS_Face& face, const ShapeFile& file);

/// The normal of a face that points out of its body; nothing where it has none.
std::optional<gp_Dir> outward_normal(const TopoDS_Face& face, double u, double v);

/// The plane of a plane face, also of one that is written as a spline surface, with an axis that points out
/// of its body.
std::optional<gp_Pln> plane_of(const TopoDS_Face& face);

}  // namespace gsim::solid
