#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "machine/import/imported.h"

namespace gsim::import {

/// Whether a text has lines as grbl answers `$$` with: "$110=5000.000".
bool is_grbl_dump(std::string_view text);

/// Reads what grbl 1.1 (or a relative with the same numbers) answers `$$` with: steps, speeds, accelerations,
/// travels, junction deviation and arc tolerance; and, where they are in it, the lines of `$#`: work
/// coordinate systems, G28, G30, G92. The error is "file:line: sentence".
tl::expected<Imported, std::string> import_grbl(std::string_view text, std::string_view file_name);

}  // namespace gsim::import
