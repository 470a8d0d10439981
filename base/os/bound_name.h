#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::os {

/// The parts of a name of a file below a folder ("cell/table.toml"), which leads nowhere else: none is empty,
/// "." or "..", hidden (begins with a dot), no UTF-8, or has a control character or a backslash. The error is
/// a sentence.
tl::expected<std::vector<std::string>, std::string> parts_of_bound_name(std::string_view name);

}  // namespace gsim::os
