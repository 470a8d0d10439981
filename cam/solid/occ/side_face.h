#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cam/solid/occ/plate_frame.h"

namespace gsim::solid {

/// A stretch of an edge of the upper side, and how the side face below it leans.
struct BevelStretch {
    double from = 0, to = 0;  ///< Parameters of the edge's curve.
    double bevel_deg = 0;     ///< Above 0 the part is smaller below.
};

/// Stretches along an edge in the order of its parameters; within each the lean changes by half a degree at
/// most. An error where a straight jet cannot cut the face through the whole plate in one go: the end of a
/// sentence that begins with the face's name.
tl::expected<std::vector<BevelStretch>, std::string> bevels_along(const TopoDS_Edge& edge,
                                                                  const TopoDS_Face& side,
                                                                  const PlateFrame& frame,
                                                                  double thickness_mm);

}  // namespace gsim::solid
