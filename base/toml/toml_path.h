#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gsim::base {

/// A key of a table, or the number of an element of an array, from 0.
using TomlStep = std::variant<std::string, std::size_t>;
/// Position of a value in a document: axis, 0, max_mm. An empty path is the document.
using TomlPath = std::vector<TomlStep>;

/// Returns the path for messages: "axis[0].max_mm".
std::string display_text(const TomlPath& path);

/// True if `path` leads to `to` or further.
bool has_prefix(const TomlPath& path, const TomlPath& to);

/// Returns the path with one more step.
TomlPath below(TomlPath path, TomlStep step);

/// Returns a key as it is written, in quotation marks if it needs them.
std::string toml_key(std::string_view key);

/// Returns the keys of a path from its step `first` on, joined by dots as in a table's name.
std::string toml_keys(const TomlPath& path, std::size_t first = 0);

}  // namespace gsim::base
