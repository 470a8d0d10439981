#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "lexer/alias.h"
#include "lexer/source.h"
#include "lexer/style.h"

namespace gsim::codegen {

/// Where the GOTOs of one program of a file lead: only these blocks need a label in Lua.
struct ProgramJumps {
    std::set<std::uint32_t> targets;
    bool computed =
        false;           ///< Some GOTO goes to a number that is known at run time only: any N may be meant.
    bool calls = false;  ///< M98 stands in it.
    bool returns_to_blocks = false;  ///< M99 P stands in a subprogram of the file.
    std::uint32_t last_line = 0;     ///< Of its last block that says something.
};

/// What a first reading of the file tells, before a line is written.
struct FileScan {
    std::uint32_t leader_lines = 0;   ///< At the start, which are passed over.
    bool starts_with_part = false;    ///< A program or a subroutine begins before any other block.
    std::vector<ProgramJumps> jumps;  ///< By program in the order of the file; empty where there is no GOTO.

    /// Jumps of the program with this ordinal number.
    const ProgramJumps& program(std::size_t ordinal) const;
};

/// Reads the source once from its start, and rewinds it. Errors in the program are left to the second
/// reading.
FileScan scan_file(lexer::Source& source, const lexer::Aliases& aliases, lexer::Style style);

}  // namespace gsim::codegen
