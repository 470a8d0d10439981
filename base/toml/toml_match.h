#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/text/json.h"

namespace gsim::base {

/// For each element of `wanted` the one of `old` that becomes it, each at most once: first the same values,
/// as many as possible in their order, then what stands between them where as many have gone as have come.
/// Where these are not as many a plain value is a new one.
std::vector<std::optional<std::size_t>> match_elements(const nlohmann::json& old,
                                                       const nlohmann::json& wanted);

}  // namespace gsim::base
