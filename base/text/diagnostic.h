#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/text/diagnostic_kind.h"

namespace gsim::text {

enum class Severity : std::uint8_t {
#define GSIM_SEVERITY(name, number, constant) name = (number),
#include "base/kinds/severity.def"
};

/// Returns "error", "warning" or "note".
std::string_view name(Severity severity);

/// One message about an input or a run. Lines and columns count from 1, columns in bytes; 0: not known.
struct Diagnostic {
    Severity severity = Severity::error;
    DiagnosticKind kind = DiagnosticKind::warning;
    std::string file = {};  ///< Name as given; empty if no file applies.
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t end_column = 0;  ///< Column of the first byte past the text meant, on the same line.
    std::string text = {};         ///< Message, without its full stop.
    std::string hint = {};         ///< Suggested fix; empty if none is known.
    std::string excerpt = {};      ///< The line and a caret below, for people; complete lines or empty.
};

/// Returns "part.nc:12:7", with as much of it as is known; empty without a file.
std::string location_text(const Diagnostic& diagnostic);

/// Returns "part.nc:12:7: error: text; hint" and the excerpt, in complete lines.
std::string to_text(const Diagnostic& diagnostic);

/// Reads an error of our file readers, "name.toml:12:7: error: text", into a diagnostic of this kind. Source
/// location and severity may be missing.
Diagnostic to_diagnostic(DiagnosticKind kind, std::string_view message);

}  // namespace gsim::text
