#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace gsim::text {

/// Returns the name of `known` that was most likely meant by `word`: the one with the fewest insertions,
/// deletions and substitutions of characters, if that is at most half of the longer name's length. Upper and
/// lower case count as equal.
std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> known);

}  // namespace gsim::text
