#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "codegen/flow/program_map.h"

namespace gsim::codegen {

/// Writer of the functions of a file of Lua, with their map: `program(12, function() ... end)`, `sub(100,
/// function() ... end)`, and `more(function() ... end)` for the part of a program that follows a subroutine.
/// Text is appended to the line that is being built.
class FunctionWriter {
  public:
    /// Returns true inside of a function.
    bool open() const { return open_; }
    /// Begins a program; `name` is a Lua literal: a number, a quoted text, or nil.
    void begin_program(std::string_view name, std::string& line);
    /// Begins a subroutine; the text that follows it belongs to the program before it again.
    void begin_sub(std::string_view name, std::string& line);
    /// Continues the program after a subroutine, or begins one without a name.
    void begin_remainder(std::string& line);
    void end(std::string& line);
    /// Forbids to split the open function.
    void forbid_cuts() { map_.back().cuts.clear(); }
    /// Records a written line, the end of line included. `may_cut`: the function may be split after it.
    /// `plain`: it has only calls with numbers, which run faster in a part that has no other text before
    /// them.
    void end_line(std::uint64_t bytes, bool may_cut, bool plain);

    /// Returns the number of the line that is being built, from 1.
    std::uint32_t line_number() const { return line_number_; }
    const ProgramMap& map() const { return map_; }

  private:
    void begin(std::string head, std::string& line);

    ProgramMap map_;
    std::uint64_t written_bytes_ = 0;  ///< Bytes before the line.
    std::uint32_t line_number_ = 1;
    std::uint32_t last_cut_line_ = 0;
    bool open_ = false;
    bool program_begun_ = false;
};

}  // namespace gsim::codegen
