#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace gsim::engine {

enum class Severity : std::uint8_t {
#define GSIM_SEVERITY(name, number, constant) name = (number),
#include "base/kinds/severity.def"
};

/// One thing to tell about an input or a run. Lines and columns count from 1, columns in bytes; 0: not known.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string code = {};  ///< "axis-limit": stays the same from release to release (docs/diagnostics.md).
    std::string file = {};  ///< As it was named; empty where there is none.
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t end_column = 0;  ///< Of the first byte behind what is meant, on the same line.
    std::string text = {};         ///< A sentence, without its full stop.
    std::string hint = {};         ///< What to do about it; empty where nothing is known.
    std::string excerpt = {};      ///< The line and a caret below, for people; whole lines or empty.
};

/// Who is told what is wrong, as it is found.
using Tell = std::function<void(const Diagnostic&)>;

/// Why something was not done.
struct Failure {
    /// "file": a file cannot be read; "usage": what is asked for does not go together; "internal": a fault of
    /// this library; else as Diagnostic::code.
    std::string code;
    std::string message;      ///< A sentence. Of a program with errors the first one; Tell has got all.
    std::string file = {};    ///< Of the input; empty where the message names it.
    bool in_program = false;  ///< The program has errors, which have been told.
    std::optional<Diagnostic> first_error = {};  ///< Of such a program.
};

}  // namespace gsim::engine
