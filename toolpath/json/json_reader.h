#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "toolpath/model/place.h"

namespace gsim::path {

/// Reads a path file (docs/paths.md) strictly: unknown, double and missing keys, wrong types and names of
/// paths that do not exist are errors, as is what validate() finds. The error is "file:line:column:
/// sentence"; `file_name` is for that.
tl::expected<PathFile, std::string> read_json(std::string_view text, std::string file_name);

/// The same of bytes that come piece by piece: `read` fills a buffer and returns how many bytes it wrote, 0
/// at the end. The text is not kept.
tl::expected<PathFile, std::string> read_json(std::function<std::size_t(char*, std::size_t)> read,
                                              std::string file_name);

}  // namespace gsim::path
