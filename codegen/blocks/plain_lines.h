#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lexer/source.h"

namespace gsim::codegen {

/// First lines of a program without the influence of its dialect: in capitals, without comments in brackets
/// and after semicolons. For inspection only, not to be run.
class PlainLines {
  public:
    /// Reads the source from its start, at most 256 KiB of it.
    explicit PlainLines(lexer::Source& source);

    /// Moves to the next line with content; returns false at the end.
    bool next();
    std::uint32_t number() const { return number_; }
    std::string_view text() const { return line_; }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
    std::uint32_t number_ = 0;
    std::string line_;
};

/// Word of a plain line: a letter with a number as it is written.
struct PlainWord {
    char letter = ' ';
    std::string_view digits;  ///< "-1.250"
    double value = 0;
    int decimals = 0;  ///< Digits after the point.
};

/// Words of a plain line in order; names and expressions are skipped.
class PlainWords {
  public:
    explicit PlainWords(std::string_view line) : line_(line) {}
    /// Moves to the next word; returns false at the end.
    bool next();
    const PlainWord& word() const { return word_; }

  private:
    bool consume_number(std::size_t begin);

    std::string_view line_;
    std::size_t at_ = 0;
    PlainWord word_;
};

}  // namespace gsim::codegen
