#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "batch/plan/plan.h"

namespace gsim::batch {

/// Prints a plan as JSON for another process to continue with: its files are already resolved and do not
/// change.
std::string print_plan_json(const Plan& plan);
/// Reads such a text.
Result<Plan> read_plan_json(std::string_view text);

}  // namespace gsim::batch
