#pragma once

#include <cstddef>
#include <string_view>

#include "lexer/block_errors.h"
#include "lexer/block_text.h"
#include "lexer/expression_nesting.h"
#include "lexer/text_cursor.h"
#include "lexer/text_rules.h"
#include "lexer/token.h"

namespace gsim::lexer {

/// Reader of the tokens that are names: of programs, O-words, parameters, functions and operators. `text` is
/// the token as in the source; the result is kBad on an error.
class NameReader {
  public:
    /// Makes a reader; all arguments must outlive it.
    NameReader(BlockText& block, BlockErrors& errors, const TextCursor& cursor, ExpressionNesting& nesting,
               const TextRules& rules)
        : block_(block), errors_(errors), cursor_(cursor), nesting_(nesting), rules_(rules) {}

    /// Reads the name of a program, which follows its O.
    Token program(std::string_view text);
    /// Reads `O100` or `O<name>` of RS274/NGC.
    Token flow_name(std::string_view text);
    /// Reads O before an expression.
    Token flow_expression();
    /// Reads `#<name>`.
    Token variable(std::string_view text, Value& value);
    /// Reports `#<` or `O<` without its '>'.
    Token unterminated();
    /// Reads a function or operator of an expression, or the keyword of an O-word. Sets `kept` to the length
    /// of the name if the next one is joined to it, because blanks have no meaning in RS274/NGC.
    Token of_expression(std::string_view text, std::size_t& kept, Value& value);
    /// Reads `**`.
    Token power(Value& value);

  private:
    Slice add(std::string_view text);
    Slice strip_leading_zeros(Slice name) const;
    Token reject(std::string_view text);

    BlockText& block_;
    BlockErrors& errors_;
    const TextCursor& cursor_;
    ExpressionNesting& nesting_;
    const TextRules& rules_;
};

/// Reports a character that is no token. Returns kBad.
Token reject_character(char character, BlockErrors& errors, const TextCursor& cursor);

}  // namespace gsim::lexer
