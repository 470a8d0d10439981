#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gsim::roundtrip {

/// Part program in the generator's model. roundtrip_text.h writes it as G-code, roundtrip_interpreter.h
/// computes its effect; the two are independent of each other.

enum class Dialect { ab9, ngc };

enum class ExprKind { number, variable, named, exists, negative, function, angle, binary };

struct Expr;
using ExprPtr = std::shared_ptr<const Expr>;

struct Expr {
    ExprKind kind = ExprKind::number;
    std::string text =
        {};  ///< Digits of a number, name of a function or an operator ("MOD"), of a parameter.
    ExprPtr a = {}, b = {};  ///< Operands; `a` of a variable is its number.
};

inline ExprPtr make(Expr expr) {
    return std::make_shared<const Expr>(std::move(expr));
}
inline ExprPtr number(std::string digits) {
    return make({.kind = ExprKind::number, .text = std::move(digits)});
}
inline ExprPtr variable(ExprPtr index) {
    return make({.kind = ExprKind::variable, .a = std::move(index)});
}
inline ExprPtr variable(int index) {
    return variable(number(std::to_string(index)));
}
inline ExprPtr named(std::string name) {
    return make({.kind = ExprKind::named, .text = std::move(name)});
}
inline ExprPtr exists(std::string name) {
    return make({.kind = ExprKind::exists, .text = std::move(name)});
}
inline ExprPtr negative(ExprPtr a) {
    return make({.kind = ExprKind::negative, .a = std::move(a)});
}
inline ExprPtr function(std::string name, ExprPtr a) {
    return make({.kind = ExprKind::function, .text = std::move(name), .a = std::move(a)});
}
/// ATAN[a]/[b]
inline ExprPtr angle(ExprPtr a, ExprPtr b) {
    return make({.kind = ExprKind::angle, .a = std::move(a), .b = std::move(b)});
}
inline ExprPtr binary(ExprPtr a, std::string op, ExprPtr b) {
    return make({.kind = ExprKind::binary, .text = std::move(op), .a = std::move(a), .b = std::move(b)});
}

struct Word {
    std::string letter;  ///< "X", "AR="
    ExprPtr value;
};

struct Assignment {
    ExprPtr target;  ///< A variable or a named parameter.
    ExprPtr value;
};

/// Content of one line; the order of codes and words is irrelevant.
struct Block {
    std::vector<std::string> codes = {};  ///< "G17", "G59.1", "M6"
    std::vector<Word> words = {};
    std::vector<Assignment> assignments = {};
};

struct Statement;
using Body = std::vector<Statement>;

/// Branch of a choice; without a condition it is the last one, for else.
struct Branch {
    ExprPtr condition;
    Body body;
};

enum class StatementKind {
    block,
    choice,    ///< The first branch with a true condition.
    loop,      ///< While `condition` holds before a pass.
    do_loop,   ///< While `condition` holds after a pass.
    repeat,    ///< `count` passes.
    leave,     ///< The innermost loop ends.
    next,      ///< The next pass of the innermost loop.
    call,      ///< Call of sub `sub`, in the manner of the sub, `count` times if `count` is given.
    give_back  ///< The sub ends, with `result` if it has one.
};

struct Statement {
    StatementKind kind = StatementKind::block;
    Block block = {};
    std::vector<Branch> branches = {};
    ExprPtr condition = {}, count = {}, result = {};
    Body body = {};
    std::size_t sub = 0;
    std::vector<Word> arguments = {};  ///< By letters for a macro, in their order for an O-call.
};

enum class CallKind { m98, macro, o_word };

struct Sub {
    CallKind kind = CallKind::m98;
    Body body = {};
    ExprPtr result = {};  ///< Result at its end; may be none.
};

struct Program {
    Dialect dialect = Dialect::ab9;
    std::vector<Sub> subs;  ///< A sub calls those before it only.
    Body main;
};

/// The number that sub `index` is called by.
inline int sub_number(std::size_t index) {
    return 200 + static_cast<int>(index);
}

}  // namespace gsim::roundtrip
