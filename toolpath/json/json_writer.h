#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "toolpath/model/path.h"

namespace gsim::path {

/// Writes a well-formed program as a path file (docs/paths.md), one target to a line, in parts of some 64 KB.
/// read_json() reads an equal program back. Each path must have its own name.
void write_json(const Program& program, const std::function<void(std::string_view)>& sink);

/// Returns the same as one string.
std::string to_json(const Program& program);

}  // namespace gsim::path
