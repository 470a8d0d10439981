#pragma once

#include <string_view>
#include <vector>

#include "cam/drawing/dxf_groups.h"
#include "cam/drawing/pen.h"

namespace gsim::drawing {

/// Returns true if draw_shape() can draw an entity of this kind.
bool is_shape(std::string_view kind);

/// Draws a LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE or SPLINE at the target set in the pen. Throws
/// Error.
void draw_shape(const GroupList& entity, const Affine& map, std::uint32_t source, Pen& pen);

/// Draws a POLYLINE with its vertices.
void draw_polyline(const GroupList& entity, const std::vector<GroupList>& vertices, const Affine& map,
                   std::uint32_t source, Pen& pen);

/// Returns the map from an entity's own coordinates into those of the drawing, by its extrusion direction,
/// which must be up or down. Throws Error.
Affine ocs_to_wcs(const GroupList& entity);

}  // namespace gsim::drawing
