#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

namespace gsim::solid {

/// A closed loop of edges of a face, in order.
struct FaceLoop {
    std::vector<TopoDS_Edge> edges;
    bool is_hole = false;  ///< Within the face; else around it.
};

/// Returns the loops of a face. A face that is closed in itself, such as that of a cone, has a seam, which is
/// left out. So a slot that crosses the seam is one loop, and so are both ends.
std::vector<FaceLoop> face_loops(const TopoDS_Face& face);

}  // namespace gsim::solid
