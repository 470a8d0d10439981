#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::os {

/// Returns the parts of the name of a file below a folder ("cell/table.toml") that cannot lead elsewhere. No
/// part is empty, "." or "..", hidden (begins with a dot), invalid UTF-8, or has a control character or a
/// backslash.
Result<std::vector<std::string>> safe_name_parts(std::string_view name);

}  // namespace gsim::os
