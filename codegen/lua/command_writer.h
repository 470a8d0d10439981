#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "codegen/lua/command_line.h"
#include "codegen/lua/function_writer.h"
#include "codegen/lua/lua_spool.h"
#include "grammar/dialect.h"
#include "lexer/diagnostics.h"

namespace gsim::codegen {

/// Translator of a program of one command per line (Klipper) into Lua: line n of the source becomes line n+1.
/// It has no blocks, expressions or programs, so it needs no parser.
///
/// The controller continues after unknown text. A warning is given once for each item without effect, with
/// the count.
class CommandWriter {
  public:
    CommandWriter(const grammar::Dialect& dialect, lexer::Diagnostics& diagnostics, LuaSpool& spool,
                  bool annotate);

    void write(lexer::Source& source, std::string_view source_name);
    const ProgramMap& map() const { return parts_.map(); }
    /// Returns the last line of the source that was read.
    std::uint32_t line() const { return line_; }

  private:
    struct IgnoredText {
        lexer::Location first;
        std::uint64_t count = 0;
    };

    void begin_file(std::string_view source_name);
    void write_line(const SourceLines& lines);
    bool write_command(const SourceLines& lines, const CommandLine& line);
    void write_code(const SourceLines& lines, const CommandLine& line, const grammar::Code& code);
    void write_extended(const SourceLines& lines, const CommandLine& line,
                        const grammar::ExtendedCommand& command);
    void write_call(const SourceLines& lines, std::string_view name, const std::vector<Parameter>& parameters,
                    std::string_view texts);
    void record_ignored(std::string message, const lexer::Location& at);
    void warn_of_ignored();
    void end_line();

    const grammar::Dialect& dialect_;
    lexer::Diagnostics& diagnostics_;
    LuaSpool& spool_;
    bool annotate_;
    FunctionWriter parts_;
    std::map<std::string, const grammar::Code*, std::less<>> codes_;
    std::map<std::string, IgnoredText> ignored_;  ///< By what is said of it.
    std::uint32_t line_ = 0;
    std::string code_;
    std::string comment_;
};

}  // namespace gsim::codegen
