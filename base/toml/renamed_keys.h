#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::base {

/// Names that keys of files had before version 0.2.0. Files may have them until version 0.3.0, with a warning
/// (docs/versions.md). A table is given by its title: "[controller]".

/// Returns the old name of a key of a table, if it has one.
std::optional<std::string_view> old_key_name(std::string_view table, std::string_view key);

/// Returns the present name of a key of a table that had this one.
std::optional<std::string_view> renamed_key(std::string_view table, std::string_view old_name);

/// Returns the warning about a key that has its name of before.
std::string deprecated_key_text(std::string_view old_name, std::string_view name);

}  // namespace gsim::base
