#pragma once

#include <vector>

#include "cam/cutting/lead.h"

namespace gsim::cutting {

/// Returns the order of cuts, by their numbers, from `start` on. Cuts within an outline come before that
/// outline (which may drop out when it is cut). The cuts of one part stay together, with short paths between.
std::vector<std::size_t> cutting_order(const Layout& layout, const std::vector<Cut>& cuts,
                                       geometry::Point start);

}  // namespace gsim::cutting
