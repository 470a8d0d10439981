#pragma once

#include <span>

#include "base/text/diagnostic.h"
#include "base/text/json.h"

namespace gsim::text {

/// Returns diagnostics as reports have them: file, line, column, end_column, severity, code, text, hint.
/// Unknown values are null.
nlohmann::ordered_json to_json(std::span<const Diagnostic> diagnostics);

}  // namespace gsim::text
