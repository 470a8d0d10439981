#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "grammar/dialect.h"
#include "lexer/alias.h"
#include "lexer/source.h"

namespace gsim::codegen {

/// Targets of the GOTOs of one program of a file: only these blocks need a label in Lua.
struct ProgramJumps {
    std::set<std::uint32_t> targets;
    bool computed = false;  ///< A GOTO has a number that is known only at run time: any N may be meant.
    bool calls = false;     ///< It contains M98.
    bool returns_to_blocks = false;  ///< A subprogram of the file contains M99 P.
    std::uint32_t last_line = 0;     ///< Line of its last block with content.
};

/// Result of a first reading of the file, before a line is written.
struct FileScan {
    std::uint32_t leader_lines = 0;   ///< At the start, which are passed over.
    bool starts_with_part = false;    ///< A program or a subroutine begins before any other block.
    std::vector<ProgramJumps> jumps;  ///< By program in the order of the file; empty without a GOTO.

    /// Returns the jumps of the program with this ordinal number.
    const ProgramJumps& program(std::size_t ordinal) const;
};

/// Reads the source once from its start, and rewinds it. Leaves errors in the program to the second reading.
FileScan scan_file(lexer::Source& source, const lexer::Aliases& aliases, const grammar::Dialect& dialect);

}  // namespace gsim::codegen
