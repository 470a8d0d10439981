#include "calibrate/text/halsampler.h"

#include <algorithm>

namespace gsim::calibrate {

namespace {

constexpr std::string_view kLost = "overrun";

}  // namespace

Cells words_of(std::string_view line) {
    Cells words = cells_of(line, " \t\r");
    std::erase_if(words, [](std::string_view word) { return word.empty(); });
    return words;
}

bool is_halsampler(std::string_view line) {
    const Cells words = words_of(line);
    return std::all_of(words.begin(), words.end(),
                       [](std::string_view word) { return number_in(word).has_value() || word == kLost; });
}

tl::expected<void, std::string> read_halsampler(std::string_view text, std::size_t columns, double period_s,
                                                const TakeSample& take) {
    if (!(period_s > 0)) {
        return tl::unexpected<std::string>(
            "columns of numbers without times, as halsampler prints them: --sample-period says how far apart "
            "they are");
    }
    double count = 0;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        Cells words = words_of(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (words.empty() || words.front() == kLost) continue;
        double at = count++;
        if (words.size() == columns + 1) {
            at = number_in(words.front()).value_or(at);
            words.erase(words.begin());
        }
        if (auto taken = take(line, at * period_s, words); !taken) return taken;
    }
    return {};
}

}  // namespace gsim::calibrate
