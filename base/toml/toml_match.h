#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/text/json.h"

namespace gsim::base {

/// Returns for each element of `requested` the element of `old` that becomes it, each at most once. Equal
/// values match first, as many as possible in their order. Elements between them match if as many were
/// removed as were added. Otherwise a plain value is a new one.
std::vector<std::optional<std::size_t>> match_elements(const nlohmann::json& old,
                                                       const nlohmann::json& requested);

}  // namespace gsim::base
