#include "runtime/script/words/word_advice.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/letter_case.h"
#include "base/text/nearest_name.h"

namespace gsim::script {

namespace {

/// Letter that is a word by itself, and its meaning.
struct StandaloneWord {
    std::string_view key, meaning;
};
constexpr std::array kStandaloneWords = {
    StandaloneWord{"f", "the feed"}, StandaloneWord{"s", "the spindle speed"},
    StandaloneWord{"t", "the tool"}, StandaloneWord{"d", "the number of the tool radius offset"},
    StandaloneWord{"h", "the number of the tool length offset"}};

}  // namespace

std::string word_advice(std::string_view key, std::optional<double> value,
                        std::span<const std::string_view> used_letters) {
    const std::string lower_key = text::lower(key);
    if (lower_key != key &&
        std::find(used_letters.begin(), used_letters.end(), lower_key) != used_letters.end())
        return fmt::format("; write {}", lower_key);
    for (const StandaloneWord& word : kStandaloneWords) {
        if (word.key != lower_key) continue;
        return fmt::format("; {} is a separate word, {}({:.10g})", word.meaning, text::upper(lower_key),
                           value.value_or(1));
    }
    if (key.size() > 1) {
        if (const auto nearest = text::nearest_name(lower_key, used_letters))
            return fmt::format("; did you mean {}?", *nearest);
    }
    return used_letters.empty() ? "" : fmt::format("; it accepts {}", text::joined(used_letters, ", "));
}

}  // namespace gsim::script
