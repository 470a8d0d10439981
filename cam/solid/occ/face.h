#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>
#include <gp_Pln.hxx>
#include <optional>
#include <string>

#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Returns "conical" or the like.
std::string surface_kind(const TopoDS_Face& face);
/// Returns the middle of one of its edges.
gp_Pnt face_point(const TopoDS_Face& face);
/// Returns "the conical face #57 at (1, 2, 3)".
std::string display_text(const TopoDS_Face& face, const ShapeFile& file);

/// Returns the normal of a face that points out of its body; nothing if it has none.
std::optional<gp_Dir> outward_normal(const TopoDS_Face& face, double u, double v);

/// Returns the plane of a plane face, including a plane written as a spline surface, with an axis that points
/// out of its body.
std::optional<gp_Pln> face_plane(const TopoDS_Face& face);

}  // namespace gsim::solid
