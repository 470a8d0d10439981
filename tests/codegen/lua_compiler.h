#pragma once

#include <optional>
#include <string>

namespace gsim::codegen {

/// What Lua's compiler has against a script; nothing where it takes it.
std::optional<std::string> compile_error(const std::string& script);

/// Runs a script that needs nothing but Lua and gives the number that it returns; nothing where it fails.
std::optional<double> run_number(const std::string& script);

}  // namespace gsim::codegen
