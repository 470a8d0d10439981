#pragma once

#include <array>
#include <optional>

#include "cam/surface/jet_point.h"
#include "cam/surface/near_edges.h"

namespace gsim::surface {

/// Quarter circles into a way at its first point and out of it at its last one, through the waste. The jet
/// keeps the direction that it has there.
struct Leads {
    /// Of the tip: where it begins or ends, and half way.
    struct Quarter {
        Vector far_mm, via_mm;
    };
    Quarter in, out;
    double length_mm = 0;  ///< Of each.
};

/// Turns the way so that it begins where leads have most room, and gives them: as large as `radius_mm`, or a
/// half or a quarter of it and so on; nothing where there is no room, then the jet pierces on the contour.
std::optional<Leads> find_leads(JetWay& way, const JetShape& jet, const NearEdges& edges, double radius_mm);

}  // namespace gsim::surface
