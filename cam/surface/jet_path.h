#pragma once

#include <string>

#include "base/error.h"
#include "cam/solid/contours.h"
#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Options for the direction of the jet.
struct JetOptions {
    bool along_walls = true;    ///< Else along the face's normal, leaned by `tilt_deg`.
    double tilt_deg = 0;        ///< Sideways from the normal; above 0 the part is smaller below.
    double lead_angle_deg = 0;  ///< Forwards: the nozzle is ahead of the cut.
    double max_tilt_deg = 60;   ///< From the face's normal.

    /// Returns true if it touches the upper and the lower edge of each wall.
    bool follows_both_edges() const { return along_walls && lead_angle_deg == 0; }
};

/// Returns the jet's path round a contour, or along an open one from end to end. It is offset by half of its
/// width from the edges, runs around corners that open, and is trimmed at corners that close. The error is a
/// message: an edge where the jet would tilt too much or point up, or a curve or corner that is narrower than
/// the jet.
Result<JetPath> jet_path(const solid::WallContour& contour, const JetShape& jet, const JetOptions& options);

/// Direction in which a path with material to its left turns about an axis: outwards, so that the jet has to
/// turn about the corner, or inwards.
enum class Corner { none, convex, concave };
Corner classify_corner(const Vector& end, const Vector& start, const Vector& about);

/// Returns the angle between two directions.
double angle_between_rad(const Vector& a, const Vector& b);

/// Returns the point at a share of the path from one point to the next.
JetPoint between(const JetPoint& a, const JetPoint& b, double share);

/// Returns "(1, 2, 3)".
std::string display_text(const Vector& position);

}  // namespace gsim::surface
