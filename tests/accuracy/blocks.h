#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::accuracy {

/// Time of one line of a program, with all its moves one after the other.
struct Block {
    long line = 0;
    double start_s = 0;
    double end_s = 0;
};

/// Duration of a line; line 0 is not a line but a pause.
struct LineTime {
    long line = 0;
    double duration_s = 0;
};

/// The blocks of lines that follow one another from time 0 on.
std::vector<Block> blocks_of(const std::vector<LineTime>& times);

/// Returns the blocks in the output of `gsim-run --moves` (JSON Lines, docs/report.md). Moves without a line
/// and moves that take no time belong to no block. The error names the line that cannot be parsed.
Result<std::vector<Block>> read_blocks(std::istream& moves);

}  // namespace gsim::accuracy
