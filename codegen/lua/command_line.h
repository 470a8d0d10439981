#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lexer/diagnostics.h"
#include "lexer/source.h"

namespace gsim::codegen {

/// Blanks around words of such a line; CR is that of a line that ends in CR LF.
inline constexpr std::string_view kLineBlanks = " \t\r\v\f";

/// Parameter of a command: a letter, or a name, and the text that follows.
struct Parameter {
    std::string key;  ///< In capitals.
    std::string value;
    std::uint32_t column = 0;
};

/// Line in Klipper's structure: one command, and all other text is a parameter of it, whatever it is.
struct CommandLine {
    std::string command;  ///< In capitals, "G1", "SET_VELOCITY_LIMIT"; empty without a command.
    std::uint32_t column = 0;
    std::vector<Parameter> parameters;  ///< In their order, each a run of letters with the text that follows.
    std::string_view tail;              ///< Text after the command, without the remark.
    std::string_view remark;            ///< Text after ';'.
};

/// Splits `line`, which must outlive the result.
CommandLine command_line(std::string_view line);

/// Reads the parameters of an extended command: NAME=VALUE between blanks; returns false if one of them has
/// another form.
bool named_parameters(const CommandLine& line, std::vector<Parameter>& parameters);

/// Lines of a source, in order.
class SourceLines {
  public:
    explicit SourceLines(lexer::Source& source) : source_(source) { source.rewind(); }

    /// Moves to the next line; returns false at the end. The remainder of a line that is too long is left
    /// out.
    bool next();
    std::string_view text() const { return line_; }
    bool too_long() const { return too_long_; }
    lexer::Location at(std::uint32_t column) const { return {begin_, number_, column}; }

  private:
    bool fill();

    lexer::Source& source_;
    std::string buffer_;
    std::size_t at_ = 0;
    std::string line_;
    bool too_long_ = false;
    std::uint64_t begin_ = 0;
    std::uint64_t next_begin_ = 0;
    std::uint32_t number_ = 0;
};

}  // namespace gsim::codegen
