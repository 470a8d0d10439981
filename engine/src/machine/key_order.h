#pragma once

#include <string>
#include <vector>

#include "base/text/json.h"

namespace gsim::engine {

/// A value for the place `at` (its keys, without numbers of elements) of a machine, cell or controller file,
/// with the keys of its objects in the order in which people are told of them, and others behind these. What
/// passed the order of keys on may have lost it.
nlohmann::ordered_json in_key_order(const nlohmann::ordered_json& value, const std::vector<std::string>& at);

}  // namespace gsim::engine
