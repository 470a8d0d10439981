#pragma once

#include <span>

#include "base/text/diagnostic.h"
#include "base/text/json.h"

namespace gsim::text {

/// Diagnostics as reports have them: file, line, column, end_column, severity, code, text, hint; what is not
/// known is null.
nlohmann::ordered_json to_json(std::span<const Diagnostic> diagnostics);

}  // namespace gsim::text
