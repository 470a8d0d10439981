#include "codegen/lua/word_writer.h"

#include <algorithm>
#include <bitset>
#include <iterator>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/number.h"
#include "codegen/blocks/call_codes.h"
#include "codegen/lua/expression_writer.h"

namespace gsim::codegen {

using grammar::Block;
using lexer::Address;
using lexer::Role;
using lexer::Word;

namespace {

// Upper bounds of the instructions that Lua's compiler makes of a call and of an operand.
constexpr std::uint64_t kInstructionsPerCall = 6;
constexpr std::uint64_t kInstructionsPerOperand = 5;

bool is_code(const Call& call, char letter, std::int32_t code_x10) {
    return call.kind == Call::Kind::code && call.code->letter == letter && call.code->code_x10 == code_x10;
}

std::string called_function(const Call& call, const Word& word) {
    switch (call.kind) {
        case Call::Kind::move: return "move";
        case Call::Kind::via_point: return "CIP";
        case Call::Kind::code: return grammar::lua_name(*call.code);
        case Call::Kind::computed:
        case Call::Kind::letter:
        case Call::Kind::unknown: break;
    }
    switch (word.address) {
        case lexer::kChamfer: return "chamfer";
        case lexer::kCornerRadius: return "corner";
        case lexer::kLineAngle: return "line_angle";
        default: return std::string(1, static_cast<char>(word.address));
    }
}

void write_value(const Block& block, std::uint32_t index, const BlockValues& values, std::string& out) {
    const Word& word = block.text->words[index];
    if (values.has(index)) {
        values.write_name(index, out);
    } else if (word.expression >= 0) {
        write_number(block, word.expression, out);
    } else if (word.role == Role::program) {
        out += normalized_number(block.text->view(word.number));
    } else {
        out += text::unsigned_zero(block.text->view(word.number));
    }
}

/// A macro call may have I, J and K several times.
bool is_repeatable(Address address) {
    return address >= 'I' && address <= 'K';
}

bool repeats_letters(const Block& block, const BlockPlan& plan, const Call& call) {
    if (call.code == nullptr || call.code->words.find('*') == std::string_view::npos) return false;
    std::bitset<256> seen;
    for (const std::uint32_t index : plan.operands(call)) {
        const Address address = block.text->words[index].address;
        if (seen[address]) return true;
        seen[address] = true;
    }
    return false;
}

/// Writes {x=1, y=2}; letters that occur twice, as in a macro call, in their order: {"i", 1}, {"i", 2}.
void write_words(const Block& block, std::span<const std::uint32_t> words, bool in_order,
                 const BlockValues& values, std::string& out) {
    char separator = '{';
    for (const std::uint32_t index : words) {
        const Word& word = block.text->words[index];
        out += separator;
        if (separator == ',') out += ' ';
        if (in_order && is_repeatable(word.address)) {
            text::append_format(out, "{{\"{}\", ", lua_key(word.address));
        } else {
            out += lua_key(word.address);
            out += '=';
        }
        write_value(block, index, values, out);
        if (in_order && is_repeatable(word.address)) out += '}';
        separator = ',';
    }
    out += '}';
}

void write_operands(const Block& block, const BlockPlan& plan, const Call& call, const BlockValues& values,
                    std::string& out) {
    if (call.operand_count == 0) {
        out += "()";
        return;
    }
    if (call.shared_count > 0) out += "(shared(";
    write_words(block, plan.operands(call), repeats_letters(block, plan, call), values, out);
    if (call.shared_count == 0) return;
    out += ", ";
    write_words(block, plan.shared(call), false, values, out);
    out += "))";
}

}  // namespace

std::string normalized_number(std::string_view digits) {
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    return std::string(digits.substr(first));
}

bool all_digits(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::uint64_t weight(const Call& call) {
    return kInstructionsPerCall + kInstructionsPerOperand * call.operand_count;
}

void write_call(const Block& block, const BlockPlan& plan, const Call& call, const BlockValues& values,
                std::string& out, std::string_view suffix) {
    const Word& word = block.text->words[call.word];
    if (call.kind == Call::Kind::unknown) {
        text::append_format(out, "unknown_code(\"{}{}\") ", static_cast<char>(word.address),
                            block.text->view(word.number));
        return;
    }
    if (call.kind == Call::Kind::computed) {
        text::append_format(out, "code(\"{}\", ", static_cast<char>(word.address));
        write_value(block, call.word, values, out);
        out += ") ";
        return;
    }
    const bool returns = is_code(call, 'M', kReturnCode);
    if (returns) out += "do return (";  // in brackets: after a tail call Lua has no line number
    out += called_function(call, word);
    if (call.kind == Call::Kind::letter) {
        out += '(';
        write_value(block, call.word, values, out);
        out += ')';
    } else {
        if (!suffix.empty()) out += '(';
        write_operands(block, plan, call, values, out);
        out += suffix;
        if (!suffix.empty()) out += ')';
    }
    out += returns ? ") end " : " ";
}

}  // namespace gsim::codegen
