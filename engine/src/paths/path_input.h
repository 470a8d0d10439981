#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/error.h"
#include "base/os/cpu_limit.h"
#include "base/os/files.h"
#include "engine/diagnostic.h"
#include "engine/path_translation.h"
#include "runtime/script/lua/lua_state.h"
#include "toolpath/model/source_location.h"

namespace gsim::engine {

/// Returns an error of a path in the form for users.
Error path_error(const gsim::Error& error);

/// Reads a path from a path file that arrives in parts; the name is for messages. Errors of the path are
/// path_error(); the error is of the kind "file" if the file cannot be read.
tl::expected<path::PathFile, Error> read_path_bytes(const PathRequest::ReadBytes& read,
                                                    const std::string& name);

/// Reads a path from a path file, or from a script in Lua (.lua). The limits are for a script.
tl::expected<path::PathFile, Error> read_path(const os::Files& files, const std::string& name,
                                              const script::LuaState::Limits& limits, os::CpuLimit* cpu);

}  // namespace gsim::engine
