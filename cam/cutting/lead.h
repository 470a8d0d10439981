#pragma once

#include <optional>
#include <vector>

#include "cam/cutting/layout.h"

namespace gsim::cutting {

/// A closed cut with the way in and out of it.
struct Cut {
    geometry::Contour loop;                 ///< Begins where the lead-in ends.
    std::optional<geometry::Edge> lead_in;  ///< From the pierce; none where there is no room.
    std::optional<geometry::Edge> lead_out;
    std::size_t outline = 0;

    geometry::Point pierce() const { return lead_in ? lead_in->start : loop.vertices.front().position; }
    geometry::Point end() const { return lead_out ? lead_out->end : loop.vertices.front().position; }
};

/// The cuts of the loops, in the same order. Leads are quarter circles of `radius_mm`, or a half, a quarter
/// and so on of it where there is no room for it, that run into the loop along its tangent through what is
/// waste. They come nowhere nearer to a part than half of the kerf, and
/// keep a kerf away from each other where there is a place for that.
std::vector<Cut> add_leads(const Layout& layout, double kerf_mm, double radius_mm);

}  // namespace gsim::cutting
