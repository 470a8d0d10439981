#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/os/cpu_limit.h"
#include "base/os/files.h"
#include "engine/path_translation.h"
#include "runtime/script/lua/lua_state.h"
#include "toolpath/model/source_location.h"

namespace gsim::engine {

/// The reason why a path is missing.
struct PathError {
    bool in_path = false;  ///< The path has a mistake; else its file cannot be read.
    std::string message;   ///< A message that begins with the position, or names the file.
};

/// Reads a path from a path file that arrives in parts; the name is for messages.
tl::expected<path::PathFile, PathError> read_path_bytes(const PathRequest::ReadBytes& read,
                                                        const std::string& name);

/// Reads a path from a path file, or from a script in Lua (.lua). The limits are for a script.
tl::expected<path::PathFile, PathError> read_path(const os::Files& files, const std::string& name,
                                                  const script::LuaState::Limits& limits, os::CpuLimit* cpu);

}  // namespace gsim::engine
