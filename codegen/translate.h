#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/text/diagnostic.h"
#include "codegen/flow/program_map.h"
#include "codegen/lua/lua_spool.h"
#include "grammar/dialect.h"
#include "lexer/alias.h"
#include "lexer/source.h"

namespace gsim::codegen {

/// Handling of a code that the dialect does not have.
enum class UnknownCodePolicy : std::uint8_t {
    error,
    warn,  ///< Its word is left out; one warning per code, with the count.
};

struct TranslateOptions {
    const grammar::Dialect* dialect = &grammar::dialect_ab9();
    UnknownCodePolicy unknown = UnknownCodePolicy::error;
    std::string source_name = "part.nc";  ///< For messages and the first line of the Lua.
    bool inch = false;                    ///< The unit in force at the start, for the first line of the Lua.
    bool annotate = false;                ///< Each complete source block as a trailing comment.
    std::size_t max_errors = 100;
    lexer::Aliases aliases;
    /// Called as the source is read: true ends the translation with an error of kind run_limit and
    /// `end_reason`.
    std::function<bool()> should_stop;
    std::function<std::string()> end_reason;
};

/// Result of a translation.
struct Translation {
    bool ok = false;  ///< No error; only then the Lua is of use.
    std::optional<text::Diagnostic> first_error;
    ProgramMap programs;
};

/// Translates one source to Lua in `spool`. Each diagnostic is passed to `report_diagnostic` as soon as it is
/// known. The caller must check if the source could be read to its end (Source::error()).
Translation translate(lexer::Source& source, LuaSpool& spool, const TranslateOptions& options,
                      const std::function<void(const text::Diagnostic&)>& report_diagnostic);

/// Result of the same for a text in memory.
struct TextTranslation {
    bool ok = false;
    std::string lua;          ///< Empty unless ok.
    std::string diagnostics;  ///< As people read them.
    ProgramMap programs;      ///< Programs of `lua`.
};
TextTranslation translate_text(std::string_view gcode, const TranslateOptions& options);

}  // namespace gsim::codegen
