#pragma once

#include <optional>
#include <vector>

#include "cam/cutting/layout.h"

namespace gsim::cutting {

/// A closed cut with its lead-in and lead-out.
struct Cut {
    geometry::Contour loop;                 ///< Begins at the end of the lead-in.
    std::optional<geometry::Edge> lead_in;  ///< From the pierce; none if the space is too small.
    std::optional<geometry::Edge> lead_out;
    std::size_t outline = 0;

    geometry::Point pierce() const { return lead_in ? lead_in->start : loop.vertices.front().position; }
    geometry::Point end() const { return lead_out ? lead_out->end : loop.vertices.front().position; }
};

/// Returns the cuts of the loops, in the same order. Leads are quarter circles that run into the loop along
/// its tangent, through waste. Their radius is `radius_mm`, or a half, a quarter and so on of it if the space
/// is too small. They are never nearer to a part than half of the kerf, and keep a kerf away from each other
/// if possible.
std::vector<Cut> add_leads(const Layout& layout, double kerf_mm, double radius_mm);

}  // namespace gsim::cutting
