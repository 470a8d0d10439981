#pragma once

#include <string>
#include <vector>

#include "base/text/json.h"

namespace gsim::engine {

/// Returns a value for the position `at` (its keys, without numbers of elements) of a machine, cell or
/// controller file. The keys of its objects are in the documented order, followed by all others. The order
/// may have been lost in transmission.
nlohmann::ordered_json sort_keys(const nlohmann::ordered_json& value, const std::vector<std::string>& at);

}  // namespace gsim::engine
