#pragma once

#include <optional>
#include <string>

namespace gsim::codegen {

/// Returns the error of Lua's compiler for a script, or none if it accepts it.
std::optional<std::string> compile_error(const std::string& script);

/// Runs a script that needs only Lua, and returns its number, or none if it fails.
std::optional<double> run_number(const std::string& script);

}  // namespace gsim::codegen
