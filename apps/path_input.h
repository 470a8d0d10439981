#pragma once

#include <string>

#include <tl/expected.hpp>

#include "runtime/path/place.h"

namespace gsim::apps {

/// Reads a path from a path file, from a script in Lua (.lua), or, named "-", a path file from standard
/// input. The error is a sentence that begins with the place.
tl::expected<path::PathFile, std::string> read_path(const std::string& name);

}  // namespace gsim::apps
