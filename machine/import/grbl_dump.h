#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "machine/import/import_result.h"

namespace gsim::import {

/// True if a text has lines like the response of grbl to `$$`: "$110=5000.000".
bool is_grbl_dump(std::string_view text);

/// Reads the response of grbl 1.1 (or a relative with the same numbers) to `$$`: steps, speeds,
/// accelerations, travels, junction deviation and arc tolerance. If present, it also reads the lines of `$#`:
/// work coordinate systems, G28, G30, G92. The error is "file:line: message".
Result<ImportResult> import_grbl(std::string_view text, std::string_view file_name);

}  // namespace gsim::import
