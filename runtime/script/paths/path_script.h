#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "runtime/script/lua/lua_state.h"
#include "toolpath/model/source_location.h"

namespace gsim::script {

/// Runs a script that builds a path (docs/paths.md). point{..}, path{..} and repeated(n, path) make targets
/// with the keys of path files, and the script returns the root path. It runs in the sandbox, without a
/// machine, until `cpu`, if given, is used up. The error is "file:line: message"; errors of validate() are
/// included.
Result<path::PathFile> run_path_script(std::string_view lua, std::string file_name,
                                       const LuaState::Limits& limits = {}, os::CpuLimit* cpu = nullptr);

}  // namespace gsim::script
