#pragma once

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// The area within the offset of a contour, holes taken off, as the Clipper library computes it from points
/// along the contour that are off its arcs by `tolerance_mm` at most.
double clipper_offset_area_mm2(const Contour& contour, double distance_mm, double tolerance_mm = 5e-4);

}  // namespace gsim::geometry
