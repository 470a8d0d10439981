#pragma once

#include <span>
#include <vector>

#include "cam/linking/clear_ways.h"

namespace gsim::transit {

/// Returns the contacts along the motion of a program, the first one of each of its paths.
std::vector<path::Fault> look_at_steps(std::span<const AxisStep> steps, const RapidSpace& space,
                                       const AxisValues& start);

}  // namespace gsim::transit
