#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gsim::codegen {

/// Position in the Lua between two statements of a program, at the start of a line.
struct Cut {
    std::uint64_t offset;
    std::uint32_t line;  ///< Line of the Lua, from 1.
};

/// Function of a file of Lua: a program, a subroutine, or the part of a program that follows a subroutine.
/// Its body may be split at the cuts, because no loop is open there and no jump crosses them.
struct ProgramPart {
    std::string
        head;  ///< Lua call that receives the function, up to it: `program(12, `, `sub("drill", `, `more(`.
    std::uint64_t body_begin = 0;
    std::uint64_t body_end = 0;
    std::uint32_t first_line = 0;
    std::vector<Cut> cuts;  ///< Ascending; empty if the program has jumps.
};

/// Parts of one translation in their order.
using ProgramMap = std::vector<ProgramPart>;

}  // namespace gsim::codegen
