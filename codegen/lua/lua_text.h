#pragma once

#include <string>
#include <string_view>

namespace gsim::codegen {

/// Returns true if `name` can follow a dot in Lua: letters, digits and _, no digit first, no keyword.
bool is_lua_name(std::string_view name);

/// Appends `text` as a quoted string of Lua; bytes that are no printable ASCII are escaped.
void write_lua_string(std::string_view text, std::string& out);

}  // namespace gsim::codegen
