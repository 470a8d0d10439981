#pragma once

#include <cstdint>

namespace gsim::lexer {

/// Kinds of tokens: those of tokens.def, and the two that every grammar of Bison has.
enum Token : int {
    kEnd = 0,
    kBad = 257,  ///< Unknown to all rules of the scanner; already diagnosed. (Bison's "undefined".)
#define GSIM_TOKEN(token, in_grammar) token,
#include "lexer/tokens.def"
#undef GSIM_TOKEN
};

/// Statements of the 9/Series that write output.
enum class Print : std::uint32_t { open, close, text };

/// Keyword that follows an O-word of RS274/NGC.
enum class Flow : std::uint32_t {
    program,  ///< No keyword: a numbered program begins.
    sub,
    end_sub,
    call,
    return_,
    if_,
    else_if,
    else_,
    end_if,
    while_,
    end_while,
    do_,
    repeat,
    end_repeat,
    break_,
    continue_,
};

/// Functions and operators of expressions, as numbers in Value::index.
enum class Operator : std::uint32_t {
    add,
    subtract,
    multiply,
    divide,
    modulo,
    bit_and,
    bit_or,
    bit_xor,
    equal,
    not_equal,
    greater,
    greater_equal,
    less,
    less_equal,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    sqrt,
    abs,
    round,
    fix,
    fup,
    ln,
    exp,
    bin,
    bcd,
    power,
    near_equal,  ///< EQ and NE of RS274/NGC, which allow for rounding.
    not_near_equal,
    exists,
};

/// Value of a token: an index into the block's arena (a word, a variable's number, an operator) and its
/// position. Trivially copyable, because the parser copies it while a block has several readings.
struct Value {
    std::uint32_t index;
    std::uint32_t column;
};

}  // namespace gsim::lexer
