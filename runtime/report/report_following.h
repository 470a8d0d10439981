#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// Returns the key `following` of a report that has it (docs/report.md).
nlohmann::ordered_json following_json(const Report& report);

/// Returns the same for people, in full lines.
std::string following_text(const Report& report);

}  // namespace gsim::simulation
