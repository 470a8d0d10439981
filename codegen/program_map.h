#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gsim::codegen {

/// A place in the Lua between two statements of a program, at the start of a line.
struct Cut {
    std::uint64_t offset;
    std::uint32_t line;  ///< Of the Lua, from 1.
};

/// Where one program stands in the Lua that was written: the body of its function, and places at which the
/// body may be taken apart, since no loop is open there and nothing jumps across.
struct ProgramPart {
    std::string name;  ///< As in `program(NAME, ...`: a number, a quoted text, or nil.
    std::uint64_t body_begin = 0;
    std::uint64_t body_end = 0;
    std::uint32_t first_line = 0;
    std::vector<Cut> cuts;  ///< Ascending; none where the program has jumps.
};

/// The programs of one translation in their order.
using ProgramMap = std::vector<ProgramPart>;

}  // namespace gsim::codegen
