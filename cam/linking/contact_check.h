#pragma once

#include <span>
#include <vector>

#include "cam/linking/collision_avoidance.h"

namespace gsim::linking {

/// Returns the contacts along the motion of a program, the first one of each of its paths.
std::vector<path::TargetError> check_contacts(std::span<const AxisStep> steps, const RapidPlanner& space,
                                              const AxisValues& start);

}  // namespace gsim::linking
