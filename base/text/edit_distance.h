#pragma once

#include <cstddef>
#include <string_view>

namespace gsim::text {

/// The fewest insertions, deletions and substitutions of characters that make `b` of `a` (V. Levenshtein,
/// 1965); in time of the product of their lengths. Upper and lower case count as different.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace gsim::text
