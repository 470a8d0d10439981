#pragma once

#include "lexer/block_errors.h"
#include "lexer/text_cursor.h"

namespace gsim::lexer {

inline constexpr int kMaxBrackets = 100;

/// Nesting of the expressions in a block.
class ExpressionNesting {
  public:
    /// Makes the nesting; both arguments must outlive it.
    ExpressionNesting(BlockErrors& errors, const TextCursor& cursor) : errors_(errors), cursor_(cursor) {}

    /// Starts the next block.
    void start_block() {
        brackets_ = 0;
        to_block_end_ = false;
    }
    /// Opens a bracket. Reports an error and returns false if more than kMaxBrackets are open.
    bool open_bracket();
    /// Closes a bracket. Returns true if the expression is over.
    bool close_bracket() {
        if (brackets_ > 0) --brackets_;
        return !in_expression();
    }
    /// Makes the rest of the block, from '=' or an O-word on, an expression.
    void extend_to_block_end() { to_block_end_ = true; }
    bool in_brackets() const { return brackets_ > 0; }
    bool in_expression() const { return to_block_end_ || brackets_ > 0; }

  private:
    BlockErrors& errors_;
    const TextCursor& cursor_;
    int brackets_ = 0;
    bool to_block_end_ = false;
};

}  // namespace gsim::lexer
