#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lexer/diagnostics.h"
#include "lexer/source.h"

namespace gsim::codegen {

/// What stands around words of such a line; CR is that of a line that ends in CR LF.
inline constexpr std::string_view kLineBlanks = " \t\r\v\f";

/// What a command is given: a letter, or a name, and the text behind it.
struct Parameter {
    std::string key;  ///< In capitals.
    std::string value;
    std::uint32_t column = 0;
};

/// A line as Klipper takes it apart: one command, everything else is a parameter of it, whatever it says.
struct CommandLine {
    std::string command;  ///< In capitals, "G1", "SET_VELOCITY_LIMIT"; empty where the line says nothing.
    std::uint32_t column = 0;
    std::vector<Parameter> parameters;  ///< As they stand, each a run of letters with what is behind it.
    std::string_view tail;              ///< What stands behind the command, without the remark.
    std::string_view remark;            ///< Behind ';'.
};

/// `line` must outlive the answer.
CommandLine command_line(std::string_view line);

/// The parameters of an extended command: NAME=VALUE between blanks; false where one of them is not so.
bool named_parameters(const CommandLine& line, std::vector<Parameter>& parameters);

/// The lines of a source, one after the other.
class SourceLines {
  public:
    explicit SourceLines(lexer::Source& source) : source_(source) { source.rewind(); }

    /// Goes to the next line; false at the end. Of a line that is too long the rest is left out.
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
