#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/envelope/reach_field.h"

namespace gsim::envelope {

/// Triangles with their corners as indices, counterclockwise as seen from outside.
struct Surface {
    std::vector<Vector3d> points_mm;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Returns the surface round the nodes of a grid at a distance of at most `iso_level_mm`, none of them on the
/// grid's border. Each cube becomes six tetrahedra about one diagonal (H. W. Kuhn, 1960), and each of these
/// at most two triangles. It is closed: each edge belongs to two triangles, which use it in opposite
/// directions.
Surface extract_isosurface(const DistanceGrid& grid, double iso_level_mm);

/// Returns the volume in a closed surface, mm3.
double volume_mm3(const Surface& surface);

}  // namespace gsim::envelope
