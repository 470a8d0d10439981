#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace gsim::fuzz {

/// Returns the file name that an input pretends to have: "fuzz" with an extension, in a folder with harmless
/// files that inputs may name (tests/fuzz/beside).
std::string name_beside(std::string_view extension);

/// Returns why an error of the file `file` breaks the promise: one line, which begins with the file (or a
/// file next to it) and a line number, and a message after them. Characters that it quotes may be any other.
std::optional<std::string> fault_of_error(std::string_view error, std::string_view file);
/// Returns the same for errors without a line.
std::optional<std::string> fault_of_sentence(std::string_view error);

/// The outcome of an input that was refused with that error.
Outcome refused_with(std::string_view error, std::string_view file);

}  // namespace gsim::fuzz
