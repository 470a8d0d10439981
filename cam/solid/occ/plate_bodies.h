#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <vector>

namespace gsim::solid {

/// What a file holds, sorted.
struct Bodies {
    std::vector<TopoDS_Solid> solids;
    std::vector<TopoDS_Face> faces;  ///< Of no body.
    std::vector<TopoDS_Edge> edges;  ///< Of no face.
};

/// Faces that close round a body, as many IGES files have them, become one. The normals of a body's faces
/// point out of it.
Bodies sort_bodies(const TopoDS_Shape& shape);

}  // namespace gsim::solid
