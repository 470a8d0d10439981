#pragma once

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Returns the area within the offset of a contour, holes subtracted, as the Clipper library computes it. It
/// uses points along the contour that are off its arcs by at most `tolerance_mm`.
double clipper_offset_area_mm2(const Contour& contour, double distance_mm, double tolerance_mm = 5e-4);

}  // namespace gsim::geometry
