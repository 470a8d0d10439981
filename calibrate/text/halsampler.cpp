#include "calibrate/text/halsampler.h"

#include <algorithm>

namespace gsim::calibrate {

namespace {

constexpr std::string_view kOverrun = "overrun";

}  // namespace

Cells split_words(std::string_view line) {
    Cells words = split_cells(line, " \t\r");
    std::erase_if(words, [](std::string_view word) { return word.empty(); });
    return words;
}

bool is_halsampler(std::string_view line) {
    const Cells words = split_words(line);
    return std::all_of(words.begin(), words.end(), [](std::string_view word) {
        return parse_number(word).has_value() || word == kOverrun;
    });
}

Result<void> read_halsampler(std::string_view text, std::size_t columns, double period_s,
                             const SampleHandler& on_sample) {
    if (!(period_s > 0)) {
        return Unexpected(
            "columns of numbers without times, as halsampler prints them: --sample-period sets the time "
            "between them");
    }
    double count = 0;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        Cells words = split_words(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (words.empty() || words.front() == kOverrun) continue;
        double at = count++;
        if (words.size() == columns + 1) {
            at = parse_number(words.front()).value_or(at);
            words.erase(words.begin());
        }
        if (auto handled = on_sample(line, at * period_s, words); !handled) return handled;
    }
    return {};
}

}  // namespace gsim::calibrate
