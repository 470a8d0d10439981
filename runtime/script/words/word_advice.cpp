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
struct Alone {
    std::string_view key, meaning;
};
constexpr std::array kAlone = {Alone{"f", "the feed"}, Alone{"s", "the spindle speed"},
                               Alone{"t", "the tool"}, Alone{"d", "the number of the tool radius offset"},
                               Alone{"h", "the number of the tool length offset"}};

}  // namespace

std::string word_advice(std::string_view key, std::optional<double> value,
                        std::span<const std::string_view> taken) {
    const std::string small = text::lower(key);
    if (small != key && std::find(taken.begin(), taken.end(), small) != taken.end())
        return fmt::format("; write {}", small);
    for (const Alone& word : kAlone) {
        if (word.key != small) continue;
        return fmt::format("; {} is a word of its own, {}({:.10g})", word.meaning, text::upper(small),
                           value.value_or(1));
    }
    if (key.size() > 1) {
        if (const auto nearest = text::nearest_name(small, taken))
            return fmt::format("; did you mean {}?", *nearest);
    }
    return taken.empty() ? "" : fmt::format("; it takes {}", text::joined(taken, ", "));
}

}  // namespace gsim::script
