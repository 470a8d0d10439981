#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"

namespace gsim::batch {

/// Prints a plan as JSON for another process to continue with: its files are already resolved and do not
/// change.
std::string print_plan_json(const Plan& plan);
/// Reads such a text. The error is a message.
tl::expected<Plan, std::string> read_plan_json(std::string_view text);

}  // namespace gsim::batch
