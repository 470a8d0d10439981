#pragma once

#include <optional>
#include <vector>

#include "toolpath/rotary/rotary_plan.h"

namespace gsim::path {

/// Returns the rotary axis values at the start of each path; nullopt if they are unknown (the root), or if
/// the uses of the path leave different ones.
std::vector<std::optional<AxisValues>> rotary_entries(const Program& program, const States& states,
                                                      const std::vector<RotarySchedule>& turns);

}  // namespace gsim::path
