#pragma once

#include <array>
#include <string_view>

#include "lexer/token.h"

namespace gsim::lexer {

/// Function or operator of expressions.
struct ExpressionName {
    std::string_view name;
    Token token;
    Operator op;
    std::string_view meaning;
};

/// Keyword that follows an O-word of RS274/NGC.
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
    FlowName{"CONTINUE", Flow::continue_, "`o100 continue`: starts the next pass"},
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
