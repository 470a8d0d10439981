#pragma once

#include <cstdint>

namespace gsim::lexer {

/// Styles of part programs.
enum class Style : std::uint8_t {
    ab9,       ///< ISO with macro statements: #1=.., IF [..] GOTO, WHILE [..] DO, aliases.
    rs274ngc,  ///< RS274/NGC: O-words, named parameters, blanks without meaning, ';' before a remark.
    /// One command per line with its parameters by name (Klipper): read without the scanner.
    command_lines,
};

}  // namespace gsim::lexer
