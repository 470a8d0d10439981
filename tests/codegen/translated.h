#pragma once

#include <string>
#include <string_view>

#include "codegen/translate.h"

namespace gsim::codegen {

/// A translation as tests look at it.
struct Translated {
    bool ok = false;
    std::string lua;
    std::string
        messages;  ///< "line:column: error: text", one a line, without the source's line and the caret.

    /// Line n of the G-code in Lua, that is, line n+1, without the comment behind it.
    std::string code(std::size_t line) const;
};

/// Translates a text whose name is part.nc.
Translated translated(std::string_view gcode, const TranslateOptions& options = {});

/// The same for RS274/NGC.
Translated translated_ngc(std::string_view gcode, TranslateOptions options = {});

/// The Lua of one block, or the messages where it has an error.
std::string lua_of(std::string_view block);
std::string ngc_lua_of(std::string_view block);

}  // namespace gsim::codegen
