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

/// One message about an input or a run. Lines and columns count from 1, columns in bytes; 0: not known.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string code = {};  ///< "axis-limit": stays the same from release to release (docs/diagnostics.md).
    std::string file = {};  ///< As it was named; empty without a file.
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t end_column = 0;  ///< First byte past the marked text, on the same line.
    std::string text = {};         ///< A message, without its full stop.
    std::string hint = {};         ///< A suggested fix; empty if none is known.
    std::string excerpt = {};      ///< The line and a caret below, for people; full lines or empty.
};

/// Receives each diagnostic when it is found.
using DiagnosticHandler = std::function<void(const Diagnostic&)>;

/// The reason why an operation failed.
struct Error {
    /// "file": a file cannot be read; "usage": a conflict in the request; "internal": an error of this
    /// library; else as Diagnostic::code.
    std::string code;
    std::string message;  ///< A message. For a program with errors, the first one; the DiagnosticHandler has
                          ///< received all.
    std::string file = {};                       ///< Name of the input; empty if the message names it.
    bool in_program = false;                     ///< The program has errors, which have been reported.
    std::optional<Diagnostic> first_error = {};  ///< First error of that program.
};

}  // namespace gsim::engine
