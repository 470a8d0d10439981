#include "machine/data/machine_data_words.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

constexpr std::size_t kMaxPrintedBytes = 40;

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

}  // namespace

std::vector<DataWord> data_words(std::string_view line) {
    std::vector<DataWord> words;
    line = line.substr(0, line.find_first_of("#;"));
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t start = i;
        while (i < line.size() && !is_blank(line[i])) ++i;
        if (i > start) words.push_back({line.substr(start, i - start), start + 1});
        while (i < line.size() && is_blank(line[i])) ++i;
    }
    return words;
}

bool is_data_word(std::string_view text) {
    const auto words = data_words(text);
    return words.size() == 1 && words[0].text.size() == text.size() &&
           std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

std::string upper_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return out;
}

std::string printable_word(std::string_view word) {
    std::string out;
    for (const char c : word.substr(0, kMaxPrintedBytes))
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return word.size() > kMaxPrintedBytes ? out + "..." : out;
}

std::string number_text(double value) {
    return fmt::format("{}", value);
}

}  // namespace gsim::machine
