#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/envelope/reach_field.h"

namespace gsim::envelope {

/// Triangles with their corners as indices; seen from outside they go counterclockwise.
struct Surface {
    std::vector<Vector3d> points_mm;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The surface round the nodes of a grid whose distance is at most `level_mm`, none of which is on the
/// grid's border: each cube in six tetrahedra about one diagonal (H. W. Kuhn, 1960), and of each of these at
/// most two triangles. Closed: each edge belongs to two triangles, which take it in opposite ways.
Surface surface_at(const DistanceGrid& grid, double level_mm);

/// The volume in a closed surface, mm3.
double volume_mm3(const Surface& surface);

}  // namespace gsim::envelope
