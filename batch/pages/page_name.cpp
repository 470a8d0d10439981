#include "batch/pages/page_name.h"

#include <algorithm>

#include <fmt/format.h>

#include "batch/work/sha256.h"

namespace gsim::batch {

namespace {

constexpr std::size_t kMaxStemLength = 48;
constexpr std::size_t kHashDigits = 16;

bool is_word_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string page_name(std::string_view program) {
    std::string stem;
    for (const char c : program) {
        if (is_word_character(c)) {
            stem += c;
        } else if (!stem.empty() && stem.back() != '-') {
            stem += '-';
        }
    }
    // The end of a name is more informative than the folders before it.
    if (stem.size() > kMaxStemLength) stem.erase(0, stem.size() - kMaxStemLength);
    const std::size_t begin = std::min(stem.find_first_not_of('-'), stem.size());
    stem = stem.substr(begin, stem.find_last_not_of('-') + 1 - begin);
    return fmt::format("{}-{}.html", stem.empty() ? "program" : stem, sha256(program).substr(0, kHashDigits));
}

}  // namespace gsim::batch
