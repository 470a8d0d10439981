#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <vector>

namespace gsim::solid {

/// The contents of a file, sorted.
struct Bodies {
    std::vector<TopoDS_Solid> solids;
    std::vector<TopoDS_Face> faces;  ///< Not part of a body.
    std::vector<TopoDS_Edge> edges;  ///< Not part of a face.
};

/// Sorts the shapes of a file. Faces that enclose a body, as in many IGES files, become one body. The normals
/// of a body's faces point out of it.
Bodies sort_bodies(const TopoDS_Shape& shape);

}  // namespace gsim::solid
