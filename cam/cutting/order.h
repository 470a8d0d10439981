#pragma once

#include <vector>

#include "cam/cutting/lead.h"

namespace gsim::cutting {

/// The order in which to make cuts, by their numbers: what lies within an outline before that outline (it may
/// fall when it is cut), the cuts of one part together, with short ways between. From `start` on.
std::vector<std::size_t> cutting_order(const Layout& layout, const std::vector<Cut>& cuts,
                                       geometry::Point start);

}  // namespace gsim::cutting
