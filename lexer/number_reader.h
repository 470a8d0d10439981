#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "lexer/block_errors.h"
#include "lexer/block_text.h"
#include "lexer/text_cursor.h"
#include "lexer/token.h"

namespace gsim::lexer {

inline constexpr std::size_t kMaxNumberBytes = 24;

/// Reader of the tokens that are numbers: of expressions, blocks, variables and levels of block delete.
/// `text` is the token as in the source; the result is kBad on an error.
class NumberReader {
  public:
    /// Makes a reader; all arguments must outlive it.
    NumberReader(BlockText& block, BlockErrors& errors, const TextCursor& cursor)
        : block_(block), errors_(errors), cursor_(cursor) {}

    /// Adds a number without blanks to the text of the block; no value if it is too long, which is reported.
    std::optional<Slice> add(std::string_view digits, bool negative) {
        if (digits.size() > kMaxNumberBytes) {
            fail_length(digits.size());
            return std::nullopt;
        }
        if (!negative) return block_.add(digits);
        Slice slice = block_.add("-");
        slice.size += block_.add(digits).size;
        return slice;
    }

    /// Reads a number of an expression.
    Token number(std::string_view text, Value& value);
    /// Reads `#5`.
    Token variable(std::string_view text, Value& value);
    /// Reads `N10`.
    Token sequence(std::string_view text, Value& value);
    /// Reads `/2`.
    Token skip(std::string_view text, Value& value);

  private:
    void fail_length(std::size_t characters);

    BlockText& block_;
    BlockErrors& errors_;
    const TextCursor& cursor_;
};

}  // namespace gsim::lexer
