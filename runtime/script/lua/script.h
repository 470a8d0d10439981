#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::script {

/// A stretch of a program's Lua that can be compiled and run by itself.
struct ScriptChunk {
    std::uint64_t begin = 0;  ///< Bytes [begin, end) of the text.
    std::uint64_t end = 0;
    std::uint32_t line = 1;  ///< Line of the Lua on which it begins.
};

/// One function of a long script, to be run chunk by chunk.
struct ScriptFunction {
    std::string head;  ///< The call in Lua that takes it, up to it: `program(12, `.
    std::vector<ScriptChunk> chunks;
};

/// What the table of a dialect says of a code, for the library.
struct CodeRow {
    std::string name;   ///< Of its word: "G92_1".
    std::string group;  ///< Modal group, as messages say it; empty: none.
    std::string keys;   ///< That the table of the word may have, with blanks between them: "p q", or "axes"
                        ///< for all axes; empty: the word itself looks at them.
    std::string compensation;  ///< What becomes of it while cutter compensation is on: "refused", "refused
                               ///< beside the path", "led out" or "ends the move"; empty: it acts.
    std::string unsupported;   ///< Its meaning, where the dialect refuses it; empty: the library does it.
};

/// The Lua that is run, as a whole or, where `functions` is not empty, in pieces, so that memory does not
/// grow with it. `read` gives bytes [begin, end) of it, or a sentence that says why it cannot.
struct Script {
    std::string dialect = "ab9";  ///< Whose words it calls: "ab9", "rs274ngc" or "klipper".
    bool inch = false;            ///< It begins in inches, whatever the run has.
    std::string file_name;  ///< For places: of the G-code where lines are known to match, else of the Lua.
    std::int64_t line_difference =
        0;  ///< Line in that file minus line in the Lua: -1 for unedited generated Lua.
    std::uint64_t size = 0;
    std::size_t held_bytes = 0;  ///< Of memory, as long as it is kept.
    std::function<tl::expected<std::string, std::string>(std::uint64_t begin, std::uint64_t end)> read;
    std::vector<ScriptFunction> functions;

    static Script from_text(std::string text, std::string file_name, std::int64_t line_difference);
};

/// Finds a program that is called, by number ("12") or name, and is not in the script: the Lua of its file,
/// no value if there is no such file, or a sentence that says what is wrong with it.
using FindProgram = std::function<tl::expected<std::optional<Script>, std::string>(const std::string& name)>;

}  // namespace gsim::script
