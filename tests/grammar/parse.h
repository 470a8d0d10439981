#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grammar/dialect.h"

namespace gsim::grammar {

/// Result of the parser for a text, written down for comparison.
struct Parsed {
    /// One entry for each block, such as `N5 /1 words X=5:axis F=200`, `while (LT #1 5) do 1`; `bad` if an
    /// error was reported.
    std::vector<std::string> blocks;
    std::string messages;  ///< "line:column: text" of the errors, one a line.
    bool finished = true;  ///< The parser came to the end by itself.
};

Parsed parse(std::string_view text, const Dialect& dialect = dialect_ab9());
/// RS274/NGC.
Parsed parse_ngc(std::string_view text);

/// Returns `before` followed by `count` times `piece`.
std::string repeated(std::string before, std::string_view fragment, std::size_t count);

}  // namespace gsim::grammar
