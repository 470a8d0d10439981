#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lexer/token.h"

namespace gsim::lexer {

/// Style of programs in which a name has its meaning.
enum class NameStyle : std::uint8_t { both, ab9, rs274ngc };

/// Function or operator of expressions.
struct ExpressionName {
    std::string_view name;
    Token token;
    Operator op;
    NameStyle style;
    std::string_view meaning;
};

inline constexpr std::array kExpressionNames = {
    ExpressionName{"EQ", kRelation, Operator::equal, NameStyle::ab9, "equal"},
    ExpressionName{"EQ", kRelation, Operator::near_equal, NameStyle::rs274ngc, "equal within 0.0001"},
    ExpressionName{"NE", kRelation, Operator::not_equal, NameStyle::ab9, "not equal"},
    ExpressionName{"NE", kRelation, Operator::not_near_equal, NameStyle::rs274ngc, "not equal within 0.0001"},
    ExpressionName{"GT", kRelation, Operator::greater, NameStyle::both, "greater"},
    ExpressionName{"GE", kRelation, Operator::greater_equal, NameStyle::both, "greater or equal"},
    ExpressionName{"LT", kRelation, Operator::less, NameStyle::both, "less"},
    ExpressionName{"LE", kRelation, Operator::less_equal, NameStyle::both, "less or equal"},
    ExpressionName{"AND", kProductWord, Operator::bit_and, NameStyle::ab9,
                   "bitwise and of whole numbers; of conditions, both as truth values"},
    ExpressionName{"AND", kLogicWord, Operator::bit_and, NameStyle::rs274ngc, "logical and: 1 or 0"},
    ExpressionName{"OR", kSumWord, Operator::bit_or, NameStyle::ab9,
                   "bitwise or of whole numbers; of conditions, both as truth values"},
    ExpressionName{"OR", kLogicWord, Operator::bit_or, NameStyle::rs274ngc, "logical or: 1 or 0"},
    ExpressionName{"XOR", kSumWord, Operator::bit_xor, NameStyle::ab9,
                   "bitwise exclusive or of whole numbers; of conditions, both as truth values"},
    ExpressionName{"XOR", kLogicWord, Operator::bit_xor, NameStyle::rs274ngc, "logical exclusive or: 1 or 0"},
    ExpressionName{"MOD", kProductWord, Operator::modulo, NameStyle::both,
                   "remainder (9/Series: with the sign of the divisor; RS274/NGC: not below 0)"},
    ExpressionName{"SIN", kFunction, Operator::sin, NameStyle::both, "sine of degrees"},
    ExpressionName{"COS", kFunction, Operator::cos, NameStyle::both, "cosine of degrees"},
    ExpressionName{"TAN", kFunction, Operator::tan, NameStyle::both, "tangent of degrees"},
    ExpressionName{"ASIN", kFunction, Operator::asin, NameStyle::both, "arc sine in degrees"},
    ExpressionName{"ACOS", kFunction, Operator::acos, NameStyle::both, "arc cosine in degrees"},
    ExpressionName{"ATAN", kAtan, Operator::atan, NameStyle::both,
                   "angle in degrees; ATAN[a]/[b] of the point (b, a)"},
    ExpressionName{"SQRT", kFunction, Operator::sqrt, NameStyle::both, "square root"},
    ExpressionName{"SQR", kFunction, Operator::sqrt, NameStyle::ab9, "square root"},
    ExpressionName{"ABS", kFunction, Operator::abs, NameStyle::both, "absolute value"},
    ExpressionName{"ROUND", kFunction, Operator::round, NameStyle::both, "nearest whole number"},
    ExpressionName{"RND", kFunction, Operator::round, NameStyle::ab9, "nearest whole number"},
    ExpressionName{"FIX", kFunction, Operator::fix, NameStyle::both,
                   "whole number towards 0 (RS274/NGC: below)"},
    ExpressionName{"FUP", kFunction, Operator::fup, NameStyle::both,
                   "whole number away from 0 (RS274/NGC: above)"},
    ExpressionName{"LN", kFunction, Operator::ln, NameStyle::both, "natural logarithm"},
    ExpressionName{"EXP", kFunction, Operator::exp, NameStyle::both, "power of e"},
    ExpressionName{"BIN", kFunction, Operator::bin, NameStyle::ab9, "value of a binary-coded decimal"},
    ExpressionName{"BCD", kFunction, Operator::bcd, NameStyle::ab9, "binary-coded decimal of a value"},
    ExpressionName{"EXISTS", kExists, Operator::exists, NameStyle::rs274ngc,
                   "1 where there is such a parameter, a named one with a value, else 0"},
};

/// Keyword after an O-word of RS274/NGC.
struct FlowName {
    std::string_view name;
    Flow flow;
    std::string_view meaning;
};

inline constexpr std::array kFlowNames = {
    FlowName{"SUB", Flow::sub, "`o100 sub`: a subroutine begins"},
    FlowName{"ENDSUB", Flow::end_sub, "`o100 endsub [value]`: its end"},
    FlowName{"CALL", Flow::call, "`o100 call [a] [b]`: calls it with #1 = a, #2 = b"},
    FlowName{"RETURN", Flow::return_, "`o100 return [value]`: ends it early"},
    FlowName{"IF", Flow::if_, "`o100 if [condition]`"},
    FlowName{"ELSEIF", Flow::else_if, "`o100 elseif [condition]`"},
    FlowName{"ELSE", Flow::else_, "`o100 else`"},
    FlowName{"ENDIF", Flow::end_if, "`o100 endif`"},
    FlowName{"WHILE", Flow::while_, "`o100 while [condition]`: a loop, or the end of `do`"},
    FlowName{"ENDWHILE", Flow::end_while, "`o100 endwhile`"},
    FlowName{"DO", Flow::do_, "`o100 do`: a loop that ends in `o100 while [condition]`"},
    FlowName{"REPEAT", Flow::repeat, "`o100 repeat [count]`"},
    FlowName{"ENDREPEAT", Flow::end_repeat, "`o100 endrepeat`"},
    FlowName{"BREAK", Flow::break_, "`o100 break`: leaves the loop"},
    FlowName{"CONTINUE", Flow::continue_, "`o100 continue`: goes on with its next pass"},
};

/// Keywords of the 9/Series.
struct Keyword {
    std::string_view name;
    Token token;
};

inline constexpr std::array kKeywords = {
    Keyword{"IF", kIf}, Keyword{"THEN", kThen},   Keyword{"WHILE", kWhile},
    Keyword{"DO", kDo}, Keyword{"END", kEndLoop}, Keyword{"GOTO", kGoto},
};

}  // namespace gsim::lexer
