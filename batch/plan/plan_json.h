#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"

namespace gsim::batch {

/// A plan as JSON, for another process to go on with: its files are found, and stay those that they are.
std::string print_plan_json(const Plan& plan);
/// Such a text. The error is a sentence.
tl::expected<Plan, std::string> read_plan_json(std::string_view text);

}  // namespace gsim::batch
