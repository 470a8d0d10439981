#include "codegen/lua/expression_writer.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/number.h"
#include "codegen/lua/lua_text.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::Node;
using grammar::NodeKind;
using grammar::Operator;

namespace {

constexpr int kSum = 1;
constexpr int kProduct = 2;
constexpr int kPrimary = 3;

std::string_view operator_function(Operator op) {
    switch (op) {
        case Operator::divide: return "div";
        case Operator::modulo: return "MOD";
        case Operator::bit_and: return "AND";
        case Operator::bit_or: return "OR";
        case Operator::bit_xor: return "XOR";
        case Operator::sin: return "SIN";
        case Operator::cos: return "COS";
        case Operator::tan: return "TAN";
        case Operator::asin: return "ASIN";
        case Operator::acos: return "ACOS";
        case Operator::atan: return "ATAN";
        case Operator::sqrt: return "SQRT";
        case Operator::abs: return "ABS";
        case Operator::round: return "ROUND";
        case Operator::fix: return "FIX";
        case Operator::fup: return "FUP";
        case Operator::ln: return "LN";
        case Operator::exp: return "EXP";
        case Operator::bin: return "BIN";
        case Operator::bcd: return "BCD";
        case Operator::power: return "POW";
        default: return "";
    }
}

std::string_view relation(Operator op) {
    switch (op) {
        case Operator::equal: return " == ";
        case Operator::not_equal: return " ~= ";
        case Operator::greater: return " > ";
        case Operator::greater_equal: return " >= ";
        case Operator::less: return " < ";
        default: return " <= ";
    }
}

bool is_relation(Operator op) {
    return op >= Operator::equal && op <= Operator::less_equal;
}

bool is_near_relation(Operator op) {
    return op == Operator::near_equal || op == Operator::not_near_equal;
}

/// Appends a parameter's name as a field: p.width, or p["2nd edge"] if it is no name of Lua.
void write_named(std::string_view name, std::string& out) {
    if (is_lua_name(name)) {
        text::append_format(out, "p.{}", name);
    } else {
        out += "p[";
        write_lua_string(name, out);
        out += ']';
    }
}

void write_exists(const Block& block, const Node& variable, std::string& out) {
    out += "exists(";
    if (variable.kind == NodeKind::named) {
        write_lua_string(block.text->view(variable.number), out);
    } else if (variable.kind == NodeKind::variable) {
        out += std::to_string(variable.left);
    } else {
        write_number(block, variable.left, out);
    }
    out += ')';
}

void write_float(std::string_view digits, std::string& out) {
    out += text::unsigned_zero(digits);
    if (digits.find('.') == std::string_view::npos) out += ".0";
}

/// Returns true for a divisor that is certainly not 0, so that division by it needs no check at run time.
bool is_nonzero_literal(const Block& block, const Node& node) {
    if (node.kind != NodeKind::number) return false;
    const std::string_view digits = block.text->view(node.number);
    return std::any_of(digits.begin(), digits.end(), [](char c) { return c >= '1' && c <= '9'; });
}

bool is_zero_literal(const Block& block, const Node& node) {
    return node.kind == NodeKind::number && !is_nonzero_literal(block, node);
}

int precedence(const Block& block, const Node& node) {
    if (node.kind != NodeKind::binary ||
        grammar::is_condition(block, static_cast<std::int32_t>(&node - block.nodes.data())))
        return kPrimary;
    switch (node.op) {
        case Operator::add:
        case Operator::subtract: return kSum;
        case Operator::multiply: return kProduct;
        case Operator::divide: return is_nonzero_literal(block, block.node(node.right)) ? kProduct : kPrimary;
        default: return kPrimary;
    }
}

void write_operand(const Block& block, std::int32_t index, int min, std::string& out) {
    const bool needs_brackets = precedence(block, block.node(index)) < min;
    if (needs_brackets) out += '(';
    write_number(block, index, out);
    if (needs_brackets) out += ')';
}

void write_call(const Block& block, const Node& node, std::string& out) {
    out += operator_function(node.op);
    out += '(';
    write_number(block, node.left, out);
    if (node.right >= 0) {
        out += ", ";
        write_number(block, node.right, out);
    }
    out += ')';
}

void write_binary(const Block& block, std::int32_t index, std::string& out) {
    const Node& node = block.node(index);
    if (grammar::is_condition(block, index)) {
        out += "number(";
        write_condition(block, index, out);
        out += ')';
        return;
    }
    const int level = precedence(block, node);
    if (level == kPrimary) return write_call(block, node, out);
    write_operand(block, node.left, level, out);
    constexpr std::string_view kOperatorSymbols = "+-*/";
    out += ' ';
    out += kOperatorSymbols[static_cast<std::size_t>(node.op)];
    out += ' ';
    write_operand(block, node.right, level + 1, out);
}

/// Lua reads 200 levels in total; the statements around an expression need some of them.
constexpr int kMaxLuaLevels = 150;

/// Returns the levels of Lua's nesting that one node needs, given those of its children: one for each
/// bracket, index or call, one for the right side of an operator.
int lua_levels(const Block& block, std::int32_t index, const std::vector<int>& levels) {
    const Node& node = block.node(index);
    const auto of = [&](std::int32_t child) { return levels[static_cast<std::size_t>(child)]; };
    const auto in_brackets = [&](std::int32_t child, int min) {
        return of(child) + (precedence(block, block.node(child)) < min ? 1 : 0);
    };
    switch (node.kind) {
        case NodeKind::number: return 0;
        case NodeKind::variable: return 1;
        case NodeKind::indirect: return of(node.left) + 1;
        case NodeKind::negate: return in_brackets(node.left, kPrimary) + 2;
        case NodeKind::named: return 1;
        case NodeKind::exists: return of(node.left) + 1;
        case NodeKind::call: return std::max(of(node.left), node.right >= 0 ? of(node.right) : 0) + 1;
        case NodeKind::binary: break;
    }
    const int level = precedence(block, node);
    if (level != kPrimary)
        return std::max(in_brackets(node.left, level), in_brackets(node.right, level + 1) + 1);
    const int calls = node.op == Operator::not_near_equal ? 3 : is_near_relation(node.op) ? 2 : 1;
    return std::max(of(node.left), of(node.right) + 1) + calls;
}

}  // namespace

std::optional<std::uint32_t> nested_too_deep(const Block& block, int used_levels) {
    std::vector<int> levels;
    levels.reserve(block.nodes.size());
    for (std::size_t i = 0; i < block.nodes.size(); ++i) {  // children come before their parents
        levels.push_back(lua_levels(block, static_cast<std::int32_t>(i), levels));
        if (levels.back() > kMaxLuaLevels - used_levels) return block.nodes[i].column;
    }
    return std::nullopt;
}

void write_number(const Block& block, std::int32_t index, std::string& out) {
    const Node& node = block.node(index);
    switch (node.kind) {
        case NodeKind::number: write_float(block.text->view(node.number), out); return;
        case NodeKind::variable: text::append_format(out, "v[{}]", node.left); return;
        case NodeKind::indirect:
            out += "v[";
            write_number(block, node.left, out);
            out += ']';
            return;
        case NodeKind::negate:
            if (is_zero_literal(block, block.node(node.left))) return write_number(block, node.left, out);
            out += "(-";
            write_operand(block, node.left, kPrimary, out);
            out += ')';
            return;
        case NodeKind::binary: write_binary(block, index, out); return;
        case NodeKind::call: write_call(block, node, out); return;
        case NodeKind::named: write_named(block.text->view(node.number), out); return;
        case NodeKind::exists: write_exists(block, block.node(node.left), out); return;
    }
}

void write_condition(const Block& block, std::int32_t index, std::string& out) {
    const Node& node = block.node(index);
    if (!grammar::is_condition(block, index)) {
        out += "truth(";
        write_number(block, index, out);
        out += ')';
        return;
    }
    if (is_near_relation(node.op)) {
        out += node.op == Operator::near_equal ? "equal(" : "not equal(";
        write_number(block, node.left, out);
        out += ", ";
        write_number(block, node.right, out);
        out += ')';
        return;
    }
    if (is_relation(node.op)) {
        write_number(block, node.left, out);
        out += relation(node.op);
        write_number(block, node.right, out);
        return;
    }
    const std::string_view joint = node.op == Operator::bit_and  ? ") and ("
                                   : node.op == Operator::bit_or ? ") or ("
                                                                 : ") ~= (";
    out += '(';
    write_condition(block, node.left, out);
    out += joint;
    write_condition(block, node.right, out);
    out += ')';
}

}  // namespace gsim::codegen
