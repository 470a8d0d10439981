#pragma once

#include <string>
#include <string_view>

#include "codegen/translate.h"

namespace gsim::codegen {

/// Translation in the form that tests check.
struct Translated {
    bool ok = false;
    std::string lua;
    std::string
        messages;  ///< "line:column: error: text", one a line, without the source's line and the caret.

    /// Returns line n of the G-code in Lua, that is, line n+1, without the comment after it.
    std::string code(std::size_t line) const;
};

/// Translates a text with the file name part.nc.
Translated translated(std::string_view gcode, const TranslateOptions& options = {});

/// The same for RS274/NGC.
Translated translated_ngc(std::string_view gcode, TranslateOptions options = {});

/// Returns the Lua of one block, or the messages if it has an error.
std::string lua_of(std::string_view block);
std::string ngc_lua_of(std::string_view block);

}  // namespace gsim::codegen
