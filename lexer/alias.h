#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/text/edit_distance.h"

namespace gsim::lexer {

/// Names for a word of the language, such as WaterJetOn for M08 (the controller's machine data). Names are
/// case-insensitive, like the full language.
class Aliases {
  public:
    struct Word {
        char letter = 'M';   ///< Upper case.
        std::string number;  ///< Digits as given.
    };

    /// Adds one. The error describes what is invalid in the name (letters, digits, `_`; a letter first; at
    /// least two characters) or in the word (one letter and a number).
    std::optional<std::string> add(std::string_view name, std::string_view word);

    /// Returns the word of a name, or null.
    const Word* find(std::string_view name) const;
    /// Returns true if some name means this letter and integer.
    bool has_alias_of(char letter, int number) const;
    /// Returns the known name that `name` most likely meant, or an empty text.
    std::string nearest(std::string_view name) const;

  private:
    std::map<std::string, Word, std::less<>> words_;  // by name in upper case
};

/// Returns the one of `candidates` with the smallest edit distance to `name`. The distance must be at most 2,
/// at most half of the name's length, and less than it.
template <typename Range>
std::string nearest_name(std::string_view name, const Range& candidates);

template <typename Range>
std::string nearest_name(std::string_view name, const Range& candidates) {
    std::string best;
    std::size_t best_distance = std::min<std::size_t>(3, name.size() / 2 + 1);  // short names: one letter
    for (const auto& candidate : candidates) {
        const std::size_t distance = text::edit_distance(name, candidate);
        if (distance < best_distance && distance < name.size()) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace gsim::lexer
