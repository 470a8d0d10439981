#pragma once

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Max depth, in mm, that a jet along a wall may cut into its lower edge before it leaves the wall's lines
/// for that.
inline constexpr double kAllowedGouge_mm = 0.02;

/// Returns the component of a direction across another one, of length 1.
Vector perpendicular(const Vector& direction, const Vector& axis);

/// Moves the axis so that the jet touches the upper and the lower edge of a wall, offset by half of its width
/// from both. `at.lateral` and `at.lower_offset_direction` are the wall's normals there at first. They differ
/// if the wall is twisted; the axis is then not a line of the wall.
void align_to_both_edges(JetPoint& at, const JetShape& jet);

/// Does the same if a jet along the wall, as in `at`, would cut more than hundredths into its lower edge. So
/// the jet is upright if walls are, and rotary axes need not turn for less.
void align_to_twisted_wall(JetPoint& at, const JetShape& jet);

/// Moves the lower end of the jet to a position; its upper end touches the edge as before.
void aim_lower_end(JetPoint& at, const Vector& lower_center_mm, const JetShape& jet);

}  // namespace gsim::surface
