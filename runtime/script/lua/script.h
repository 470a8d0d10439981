#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::script {

/// Part of a program's Lua that can be compiled and run by itself.
struct ScriptChunk {
    std::uint64_t begin = 0;  ///< Bytes [begin, end) of the text.
    std::uint64_t end = 0;
    std::uint32_t line = 1;  ///< Line of the Lua on which it begins.
};

/// Function of a long script, to be run chunk by chunk.
struct ScriptFunction {
    std::string head;  ///< Lua call that receives it, up to it: `program(12, `.
    std::vector<ScriptChunk> chunks;
};

/// Row of a dialect's table for a code, for the library.
struct CodeRow {
    std::string name;   ///< Name of its word: "G92_1".
    std::string group;  ///< Modal group as in messages; empty: no group.
    std::string keys;  ///< Permitted keys of the table of the word, separated by blanks: "p q", or "axes" for
                       ///< all axes; empty: the word itself checks them.
    std::string compensation;  ///< Effect of cutter compensation on it: "refused", "refused beside the path",
                               ///< "led out" or "ends the move"; empty: it acts.
    std::string unsupported;   ///< Its meaning, if the dialect rejects it; empty: the library implements it.
};

/// Lua that is run in full, or in parts if `functions` is not empty, so that memory does not grow with it.
/// `read` returns bytes [begin, end) of it, or an error message.
struct Script {
    std::string dialect = "ab9";  ///< Dialect of its words: "ab9", "rs274ngc" or "klipper".
    bool inch = false;            ///< It begins in inches, whatever the run has.
    std::string
        file_name;  ///< For source locations: the G-code file if lines are known to match, else the Lua.
    std::int64_t line_offset =
        0;  ///< Line in that file minus line in the Lua: -1 for unedited generated Lua.
    std::uint64_t size = 0;
    std::size_t retained_bytes = 0;  ///< Bytes of memory, as long as it is kept.
    std::function<Result<std::string>(std::uint64_t begin, std::uint64_t end)> read;
    std::vector<ScriptFunction> functions;

    static Script from_text(std::string text, std::string file_name, std::int64_t line_offset);
};

/// Finds a program that is called, by number ("12") or name, and is not in the script. Returns the Lua of its
/// file, no value if such a file does not exist, or an error message.
using FindProgram = std::function<Result<std::optional<Script>>(const std::string& name)>;

}  // namespace gsim::script
