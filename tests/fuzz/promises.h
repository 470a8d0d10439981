#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace gsim::fuzz {

/// The name of the file that an input pretends to be: "fuzz" with an ending, in a folder with harmless files
/// that inputs may name (tests/fuzz/beside).
std::string name_beside(std::string_view ending);

/// Why an error of the file `file` is not what is promised: one line, which begins with the file (or a file
/// beside it) and a line number, and a sentence behind them. Characters that it quotes may be any other.
std::optional<std::string> fault_of_error(std::string_view error, std::string_view file);
/// The same where no line can be named.
std::optional<std::string> fault_of_sentence(std::string_view error);

/// The outcome of an input that was refused with that error.
Outcome refused_with(std::string_view error, std::string_view file);

}  // namespace gsim::fuzz
