#pragma once

#include <cstddef>
#include <string_view>

namespace gsim::text {

/// Returns the min number of insertions, deletions and substitutions of characters that turn `a` into `b` (V.
/// Levenshtein, 1965). The time is proportional to the product of their lengths. Upper and lower case count
/// as different.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace gsim::text
