#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "lexer/source.h"

namespace gsim::lexer {

/// Reader of a source that cuts lines before they reach the scanner, because the scanner's buffer grows with
/// the longest token. So a file without a line end, however long, needs the memory of one line.
class LineGuard {
  public:
    explicit LineGuard(Source& source) : source_(source) {}

    /// Reads up to `capacity` bytes of lines, each cut to kMaxLineBytes. Returns their number, 0 at the end.
    std::size_t fill(char* buffer, std::size_t capacity);
    /// Returns the number of bytes that were cut off a line, and forgets it; no value if it is complete. To
    /// be called for all lines in their order.
    std::optional<std::uint64_t> release_cut(std::uint32_t line);

  private:
    struct TruncatedLine {
        std::uint32_t line;
        std::uint64_t dropped_bytes;
    };

    Source& source_;
    std::uint32_t read_line_ = 1;
    std::size_t read_line_bytes_ = 0;
    std::deque<TruncatedLine> truncated_lines_;
};

}  // namespace gsim::lexer
