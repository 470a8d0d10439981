#pragma once

#include <cstddef>
#include <cstdint>

namespace gsim::lexer {

/// Position of the scanner in its source: line and column of the last token.
class TextCursor {
  public:
    /// Passes over bytes before the first line.
    void skip(std::uint64_t bytes) { line_begin_ += bytes; }
    /// Passes over a token, which becomes the last one.
    void advance(std::size_t size) {
        column_ = next_column_;
        size_ = static_cast<std::uint32_t>(size);
        next_column_ += size_;
    }
    /// Returns to the first `kept` bytes of the last token, and returns the number of bytes that are read
    /// again.
    std::size_t unread(std::size_t kept) {
        const std::uint32_t returned = size_ - static_cast<std::uint32_t>(kept);
        next_column_ -= returned;
        size_ = static_cast<std::uint32_t>(kept);
        return returned;
    }
    /// Starts the next line; `dropped_bytes` of this one have not reached the scanner.
    void start_line(std::uint64_t dropped_bytes) {
        ++line_;
        line_begin_ += dropped_bytes + next_column_ - 1;
        next_column_ = 1;
    }

    /// Returns the line that is read, from 1.
    std::uint32_t line() const { return line_; }
    /// Returns the start of that line, in bytes from the start of the source.
    std::uint64_t line_begin() const { return line_begin_; }
    /// Returns the column of the last token, from 1.
    std::uint32_t column() const { return column_; }
    /// Returns true if nothing of the line has been read.
    bool is_at_line_start() const { return next_column_ == 1; }

  private:
    std::uint32_t line_ = 1;
    std::uint64_t line_begin_ = 0;
    std::uint32_t next_column_ = 1;
    std::uint32_t column_ = 1;
    std::uint32_t size_ = 0;
};

}  // namespace gsim::lexer
