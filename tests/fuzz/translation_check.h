#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::fuzz {

/// Translates `gcode` in both dialects and checks what must hold for any input whatever: twice the same
/// result; an error has a diagnostic; a translation has the source's lines one further down and one line
/// after them, and Lua compiles it. Returns a sentence about what does not hold, nothing if all does.
std::optional<std::string> broken_promise(std::string_view gcode);

}  // namespace gsim::fuzz
