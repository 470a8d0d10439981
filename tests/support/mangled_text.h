#pragma once

#include <cctype>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>

namespace gsim::test {

/// Returns an integer from 0 to end - 1.
inline std::size_t below(std::mt19937& random, std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

/// `text` as a broken disk or a slip of the hand leaves it: one to four times something is lost, overwritten
/// by any byte, doubled, or the end is cut off.
inline std::string mangled(std::mt19937& random, std::string text) {
    for (std::size_t changes = 1 + below(random, 4); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(random, text.size());
        const std::size_t count = 1 + below(random, 20);
        switch (below(random, 4)) {
            case 0: text.erase(at, count); break;
            case 1: text[at] = static_cast<char>(below(random, 256)); break;
            case 2: text.insert(at, text.substr(below(random, text.size()), count)); break;
            default: text.resize(at); break;
        }
    }
    return text;
}

/// Returns true if an error is "file:line:column: sentence" in one line, of a file with the name "f".
inline bool is_located(std::string_view error) {
    std::size_t at = 2;
    if (error.substr(0, at) != "f:") return false;
    for (int numbers = 0; numbers < 2; ++numbers) {
        const std::size_t start = at;
        while (at < error.size() && std::isdigit(static_cast<unsigned char>(error[at])) != 0) ++at;
        if (at == start || at == error.size() || error[at++] != ':') return false;
    }
    return error.size() > at + 1 && error.find('\n') == std::string_view::npos;
}

}  // namespace gsim::test
