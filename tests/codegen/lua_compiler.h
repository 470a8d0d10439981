#pragma once

#include <optional>
#include <string>

namespace gsim::codegen {

/// What Lua's compiler has against a script; nothing where it takes it.
std::optional<std::string> compile_error(const std::string& script);

}  // namespace gsim::codegen
