#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// Returns the key `efforts` of a report that has them (docs/report.md).
nlohmann::ordered_json efforts_json(const Report& report);

/// Returns the same for people, in full lines.
std::string efforts_text(const Report& report);

}  // namespace gsim::simulation
