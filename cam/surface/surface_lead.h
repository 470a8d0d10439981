#pragma once

#include <array>
#include <optional>

#include "cam/surface/edge_proximity.h"
#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Leads into a path at its first point and out of it at its last one, through the waste. The jet keeps its
/// direction there.
struct Leads {
    /// Path of the TCP: its outer end, and the midpoint of a quarter circle; without that it is straight.
    struct Lead {
        Vector outer_mm;
        std::optional<Vector> via_mm;
    };
    std::optional<Lead> in, out;  ///< None without enough space; both for a closed path.
    double length_mm = 0;         ///< Length of each.
};

/// Rotates a closed path so that it begins at the position with the most space for leads, and returns them:
/// quarter circles with the radius `radius_mm`, or a half or a quarter of it and so on. Leads of an open path
/// continue straight past its ends, by this length. Returns nothing if the space is too small; then the jet
/// pierces on the contour.
std::optional<Leads> find_leads(JetPath& jet_path, const JetShape& jet, const EdgeProximity& edges,
                                double radius_mm);

}  // namespace gsim::surface
