#pragma once

#include <optional>
#include <vector>

#include "toolpath/rotary/rotary_plan.h"

namespace gsim::path {

/// Where the rotary axes stand when each path begins; none where that is not known (the root) or where the
/// places that use it leave them differently.
std::vector<std::optional<AxisValues>> rotary_entries(const Program& program, const States& states,
                                                      const std::vector<PathTurns>& turns);

}  // namespace gsim::path
