#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gsim::base {

/// A key of a table, or the number of an element of an array, from 0.
using TomlStep = std::variant<std::string, std::size_t>;
/// Where a value is in a document: axis, 0, max_mm. An empty one is the document.
using TomlPath = std::vector<TomlStep>;

/// For messages: "axis[0].max_mm".
std::string shown(const TomlPath& path);

/// Whether `path` leads to `to` or on from there.
bool leads_through(const TomlPath& path, const TomlPath& to);

/// The path with one more step.
TomlPath below(TomlPath path, TomlStep step);

/// A key as it is written, in quotation marks where it needs them.
std::string toml_key(std::string_view key);

/// The keys of a path, joined by dots, from its step `first` on: as a table's name has it.
std::string toml_keys(const TomlPath& path, std::size_t first = 0);

}  // namespace gsim::base
