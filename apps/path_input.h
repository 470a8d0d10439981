#pragma once

#include <string>

#include <tl/expected.hpp>

#include "os/cpu_limit.h"
#include "runtime/path/place.h"
#include "runtime/script/lua_state.h"

namespace gsim::apps {

/// Reads a path from a path file, from a script in Lua (.lua), or, named "-", a path file from standard
/// input. The limits are of a script. The error is a sentence that begins with the place.
tl::expected<path::PathFile, std::string> read_path(const std::string& name,
                                                    const script::LuaState::Limits& limits,
                                                    os::CpuLimit* cpu);

}  // namespace gsim::apps
