#pragma once

#include <array>
#include <optional>

#include "cam/surface/jet_point.h"
#include "cam/surface/near_edges.h"

namespace gsim::surface {

/// Into a way at its first point and out of it at its last one, through the waste. The jet keeps the
/// direction that it has there.
struct Leads {
    /// Of the tip: where it begins or ends, and half way on a quarter circle; without that it goes straight.
    struct Lead {
        Vector far_mm;
        std::optional<Vector> via_mm;
    };
    std::optional<Lead> in, out;  ///< None where there is no room; both at a closed way.
    double length_mm = 0;         ///< Of each.
};

/// Turns a closed way so that it begins where leads have most room, and gives them: quarter circles as large
/// as `radius_mm`, or a half or a quarter of it and so on. Those of an open way go straight on beyond its
/// ends, that far. Nothing where there is no room, then the jet pierces on the contour.
std::optional<Leads> find_leads(JetWay& way, const JetShape& jet, const NearEdges& edges, double radius_mm);

}  // namespace gsim::surface
