#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/os/cpu_limit.h"
#include "runtime/path/place.h"
#include "runtime/script/lua_state.h"

namespace gsim::apps {

/// Why there is no path.
struct PathError {
    bool in_path = false;  ///< The path has a mistake; else its file cannot be read.
    std::string message;   ///< A sentence that begins with the place, or names the file.
};

/// Reads a path from a path file, from a script in Lua (.lua), or, named "-", a path file from standard
/// input. The limits are of a script.
tl::expected<path::PathFile, PathError> read_path(const std::string& name,
                                                  const script::LuaState::Limits& limits, os::CpuLimit* cpu);

}  // namespace gsim::apps
