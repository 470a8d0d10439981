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

/// One of the functions that a file of Lua consists of: a program, a subroutine, or the rest of a program
/// behind a subroutine. Its body may be taken apart at the cuts, since no loop is open there and nothing
/// jumps across.
struct ProgramPart {
    std::string
        head;  ///< The call that takes the function, up to it: `program(12, `, `sub("drill", `, `more(`.
    std::uint64_t body_begin = 0;
    std::uint64_t body_end = 0;
    std::uint32_t first_line = 0;
    std::vector<Cut> cuts;  ///< Ascending; none where the program has jumps.
};

/// The parts of one translation in their order.
using ProgramMap = std::vector<ProgramPart>;

}  // namespace gsim::codegen
