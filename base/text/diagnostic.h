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

/// "error", "warning", "note"
std::string_view name(Severity severity);

/// One thing to tell about an input or a run. Lines and columns count from 1, columns in bytes; 0: not known.
struct Diagnostic {
    Severity severity = Severity::error;
    DiagnosticKind kind = DiagnosticKind::warning;
    std::string file = {};  ///< As it was named; empty where there is none.
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t end_column = 0;  ///< Of the first byte behind what is meant, on the same line.
    std::string text = {};         ///< A sentence, without its full stop.
    std::string hint = {};         ///< What to do about it; empty where nothing is known.
    std::string excerpt = {};      ///< The line and a caret below, for people; whole lines or empty.
};

/// "part.nc:12:7", with as much of it as is known; empty without a file.
std::string place_of(const Diagnostic& diagnostic);

/// "part.nc:12:7: error: text; hint" and the excerpt, in whole lines.
std::string to_text(const Diagnostic& diagnostic);

/// Reads what our readers of files say, "name.toml:12:7: error: text" with a place and a severity that may be
/// missing, into a diagnostic of this kind.
Diagnostic diagnostic_of(DiagnosticKind kind, std::string_view sentence);

}  // namespace gsim::text
