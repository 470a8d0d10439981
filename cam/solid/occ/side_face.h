#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <string>
#include <vector>

#include "base/error.h"
#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

/// A section of an edge of the upper side, and the tilt of the side face below it.
struct BevelInterval {
    double from = 0, to = 0;  ///< Parameters of the edge's curve.
    double bevel_deg = 0;     ///< Above 0 the part is smaller below.
};

/// Returns sections of an edge in the order of its parameters; within each the tilt changes by at most half a
/// degree. The error means that a straight jet cannot cut the face through the full plate in one pass. It is
/// the end of a message that begins with the face's name.
Result<std::vector<BevelInterval>> edge_bevels(const TopoDS_Edge& edge, const TopoDS_Face& side,
                                               const PlateFrame& frame, double thickness_mm);

}  // namespace gsim::solid
