#pragma once

#include <cstdint>

namespace gsim::lexer {

/// Kinds of tokens. The grammar declares the same numbers.
enum Token : int {
    kEnd = 0,
    kBad = 257,  ///< What no rule of the scanner knows; the diagnostic has been given. (Bison's "undefined".)
    kEob = 258,  ///< End of block: the end of the line, or ';'.
    kTape,       ///< %
    kSkip,       ///< /n
    kSequence,   ///< N10
    kProgram,    ///< O1 or another program name
    kAxis,       ///< A word whose letter is an axis and nothing else
    kAxisOrTime,  ///< X or U: an axis, or the seconds of a dwell
    kP,           ///< P: seconds, a program, a parameter
    kOther,       ///< Any other word with a value, G and M codes among them
    kDwell,       ///< G04
    kCall,        ///< M98, M99
    kAxisLetter,  ///< As above, but an expression is to follow
    kAxisOrTimeLetter,
    kPLetter,
    kOtherLetter,
    kVariable,  ///< #5
    kHash,      ///< # before an expression or another #
    kNumber,
    kFunction,  ///< SIN ...
    kAtan,
    kRelation,     ///< EQ ...
    kSumWord,      ///< OR, XOR: bind as + and -
    kProductWord,  ///< AND, MOD: bind as * and /
    kIf,
    kThen,
    kWhile,
    kDo,
    kEndLoop,
    kGoto,
    // RS274/NGC
    kFlowName,       ///< O100, O<name>
    kFlowLetter,     ///< O before an expression
    kFlow,           ///< sub, call, if ...: a Flow in Value::index
    kNamedVariable,  ///< #<name>
    kPower,          ///< **
    kLogicWord,      ///< AND, OR, XOR: bind weakest
    kExists,
    kComparison,  ///< EQ ... of RS274/NGC, which may be chained
    kPrint,       ///< DPRNT[..], POPEN or PCLOS: a Print in Value::index, its text in BlockText::print
    kSet,         ///< = among words, with one value behind it
};

/// Statements of the 9/Series that write to the outside.
enum class Print : std::uint32_t { open, close, text };

/// What stands behind an O-word of RS274/NGC.
enum class Flow : std::uint32_t {
    program,  ///< Nothing: a numbered program begins.
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

/// What a token carries: an index into the block's arena (a word, a variable's number, an operator) and where
/// it stands. Trivially copyable, as the parser copies it while a block has more than one reading.
struct Value {
    std::uint32_t index;
    std::uint32_t column;
};

}  // namespace gsim::lexer
