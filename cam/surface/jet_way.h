#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cam/solid/contours.h"
#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Which way the jet goes.
struct JetChoice {
    bool along_walls = true;   ///< Else along the face's normal, leaned by `lean_deg`.
    double lean_deg = 0;       ///< Sideways from the normal; above 0 the part is smaller below.
    double tilt_deg = 0;       ///< Forwards: the nozzle goes ahead of where it cuts.
    double max_lean_deg = 60;  ///< From the face's normal.

    /// Whether it goes beside the upper and the lower edge of each wall.
    bool touches_both() const { return along_walls && tilt_deg == 0; }
};

/// The jet's way round a contour, or along an open one from end to end: half of its width beside the edges,
/// about corners that open, trimmed where they close. The error is a sentence: an edge where the jet would
/// lean too much or go up, a bend or corner that is narrower than the jet.
tl::expected<JetWay, std::string> jet_way(const solid::WallContour& contour, const JetShape& jet,
                                          const JetChoice& choice);

/// How a way with material to its left turns from one direction to another about an axis: out of the room
/// that it has, so that the jet has to turn about the corner, or into it.
enum class Corner { none, opens, closes };
Corner corner_of(const Vector& end, const Vector& start, const Vector& about);

/// Between two directions.
double angle_between_rad(const Vector& a, const Vector& b);

/// A share of the way from one point to the next.
JetPoint between(const JetPoint& a, const JetPoint& b, double share);

/// "(1, 2, 3)"
std::string shown(const Vector& place);

}  // namespace gsim::surface
