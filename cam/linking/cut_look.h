#pragma once

#include <span>
#include <vector>

#include "cam/linking/clear_ways.h"

namespace gsim::transit {

/// What touches what on the way of a program, the first contact of each of its paths.
std::vector<path::Fault> look_at_steps(std::span<const AxisStep> steps, const RapidSpace& space,
                                       const AxisValues& start);

}  // namespace gsim::transit
