#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Reads a path file (docs/paths.md) strictly. Unknown, double and missing keys, wrong types and names of
/// paths that do not exist are errors, and so is what validate() finds. The error is "file:line:column:
/// message", with `file_name`.
Result<PathFile> read_json(std::string_view text, std::string file_name);

/// Reads the same from bytes that arrive part by part: `read` fills a buffer and returns how many bytes it
/// wrote, 0 at the end. The text is not kept.
Result<PathFile> read_json(std::function<std::size_t(char*, std::size_t)> read, std::string file_name);

}  // namespace gsim::path
