#include "base/text/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/text/edit_distance.h"
#include "base/text/letter_case.h"

namespace gsim::text {

namespace {

constexpr std::size_t kMaxWordLength = 64;  // no known name is that long

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> known) {
    if (word.size() > kMaxWordLength) return std::nullopt;
    std::optional<std::string_view> best;
    std::size_t best_distance = 0;
    const std::string lower_word = lower(word);
    for (const std::string_view name : known) {
        const std::size_t distance = edit_distance(lower_word, lower(name));
        const bool near = 2 * distance <= std::max(word.size(), name.size());
        if (!near || (best && distance >= best_distance)) continue;
        best = name;
        best_distance = distance;
    }
    return best;
}

}  // namespace gsim::text
