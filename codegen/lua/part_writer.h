#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "codegen/flow/program_map.h"

namespace gsim::codegen {

/// Writes the functions that a file of Lua consists of, and keeps their map: `program(12, function() ...
/// end)`, `sub(100, function() ... end)`, and `more(function() ... end)` for what a program has behind a
/// subroutine. Text is appended to the line that is being put together.
class PartWriter {
  public:
    /// True inside of a function.
    bool open() const { return open_; }
    /// Begins a program; `name` is a Lua literal: a number, a quoted text, or nil.
    void begin_program(std::string_view name, std::string& line);
    /// Begins a subroutine; what stands behind it belongs to the program before it again.
    void begin_sub(std::string_view name, std::string& line);
    /// Goes on with the program behind a subroutine, or begins one without a name.
    void begin_rest(std::string& line);
    void end(std::string& line);
    /// The open function cannot be taken apart.
    void forbid_cuts() { map_.back().cuts.clear(); }
    /// A line has been written, the end of line included; `may_cut`: the function may be taken apart behind
    /// it; `plain`: it has calls with numbers only, which run faster in a piece that has nothing else in
    /// front.
    void end_line(std::uint64_t bytes, bool may_cut, bool plain);

    /// Number of the line that is being put together, from 1.
    std::uint32_t line_number() const { return line_number_; }
    const ProgramMap& map() const { return map_; }

  private:
    void begin(std::string head, std::string& line);

    ProgramMap map_;
    std::uint64_t written_ = 0;  ///< Bytes before the line.
    std::uint32_t line_number_ = 1;
    std::uint32_t last_cut_line_ = 0;
    bool open_ = false;
    bool program_begun_ = false;
};

}  // namespace gsim::codegen
