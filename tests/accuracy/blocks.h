#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::accuracy {

/// The time that one line of a program takes, with all the moves it makes one after the other.
struct Block {
    long line = 0;
    double start_s = 0;
    double end_s = 0;
};

/// How long a line took; line 0 is no line: a pause.
struct LineTime {
    long line = 0;
    double duration_s = 0;
};

/// The blocks of lines that follow one another from time 0 on.
std::vector<Block> blocks_of(const std::vector<LineTime>& times);

/// The blocks in what `gsim-run --moves` writes: JSON Lines, docs/report.md. Moves that belong to no line and
/// those that take no time are in none. The error says which line cannot be understood.
tl::expected<std::vector<Block>, std::string> read_blocks(std::istream& moves);

}  // namespace gsim::accuracy
