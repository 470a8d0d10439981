#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::os {

/// Returns the parts of the name of a file below a folder ("cell/table.toml") that cannot lead elsewhere. No
/// part is empty, "." or "..", hidden (begins with a dot), invalid UTF-8, or has a control character or a
/// backslash. The error is a message.
tl::expected<std::vector<std::string>, std::string> safe_name_parts(std::string_view name);

}  // namespace gsim::os
