// Part of LuaWriter that writes jumps and records calls: GOTO, M99 P, M98.

#include <charconv>
#include <iterator>

#include <fmt/format.h>

#include "base/text/format.h"
#include "codegen/lua/expression_writer.h"
#include "codegen/lua/lua_writer.h"
#include "codegen/lua/word_writer.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::BlockKind;
using grammar::Node;
using grammar::NodeKind;
using lexer::DiagnosticKind;
using lexer::Word;

namespace {

constexpr std::uint64_t kInstructionsPerCase = 4;  // an upper bound of what Lua's compiler makes of one

}  // namespace

/// The block at which to continue is a local variable: a call that does not set it leaves it nil.
void LuaWriter::declare_jump(std::string& line) const {
    if (flow_.computed()) line += "local jump ";
}

/// Writes M99 P in the main program as a jump to one of its blocks. Returns false if it has no P.
bool LuaWriter::write_return_goto(const Block& block, const Call& call) {
    if (call.operand_count == 0 || !plan_.dialect().rules().has_block_jumps) return false;
    const Word& word = block.text->words[plan_.operands(call).front()];
    if (word.expression >= 0) {
        code_ += "jump = goto_target(";
        write_number(block, word.expression, code_);
        code_ += ") ";
        write_computed_jump();
        code_ += ' ';
    } else if (const auto target = block_number(block, word.number, word.column)) {
        write_jump_to(block, *target, word.column);
        code_ += ' ';
    }
    return true;
}

/// Returns the number of the block that a jump targets, or no value if the error was reported.
std::optional<std::uint32_t> LuaWriter::block_number(const Block& block, lexer::Slice digits_slice,
                                                     std::uint32_t column) {
    const std::string_view digits = block.text->view(digits_slice);
    const std::string number = all_digits(digits) ? normalized_number(digits) : "";
    std::uint32_t value = 0;
    if (number.empty() || number.size() > 9) {
        errors_.fail(column, DiagnosticKind::jump,
                     fmt::format("the target of a jump must be a block number, not {}", digits));
        return std::nullopt;
    }
    std::from_chars(number.data(), number.data() + number.size(), value);
    return value;
}

void LuaWriter::record_call(const Block& block, const Call& call) {
    for (const std::uint32_t index : plan_.operands(call)) {
        const Word& word = block.text->words[index];
        if (word.expression >= 0) continue;
        const std::string_view digits = block.text->view(word.number);
        const std::string number = all_digits(digits) ? normalized_number(digits) : "";
        if (number.empty() || number.size() > 9) {
            errors_.fail(word.column, DiagnosticKind::number,
                         fmt::format("{} of M98 must be an integer, not {}",
                                     lexer::address_name(word.address), digits));
            return;
        }
        std::uint32_t value = 0;
        std::from_chars(number.data(), number.data() + number.size(), value);
        if (word.address == 'P') names_.add_call(value, block.text->at(word.column));
    }
}

void LuaWriter::write_goto(const Block& block) {
    const Node& target = block.node(block.target);
    if (target.kind != NodeKind::number) {
        code_ += "jump = goto_target(";
        write_number(block, block.target, code_);
        code_ += ") ";
        write_computed_jump();
        return;
    }
    const auto number = block_number(block, target.number, block.target_column);
    if (!number) return;
    write_jump_to(block, *number, block.target_column);
}

/// An unconditional jump back at the end of the main program repeats indefinitely: each time is a pass.
bool LuaWriter::ends_pass(const Block& block, std::uint32_t target) const {
    const bool conditional = block.kind == BlockKind::if_then || block.kind == BlockKind::if_goto;
    return next_ordinal_ == 1 && !conditional && !flow_.in_loop() && flow_.has_label(target) &&
           block.text->at(1).line == scan_.program(0).last_line;
}

void LuaWriter::write_jump_to(const Block& block, std::uint32_t target, std::uint32_t column) {
    flow_.add_jump(target, block.text->at(column));
    if (ends_pass(block, target)) text::append_format(code_, "if last_pass({}) then return end ", target);
    text::append_format(code_, "goto N{}", target);
}

void LuaWriter::write_computed_jump() {
    text::append_format(code_, "goto {}", flow_.add_computed_jump());
}

void LuaWriter::write_number_dispatch(std::span<const std::uint32_t> numbers) {
    flow_.add_weight(numbers.size() * kInstructionsPerCase);
    for (const std::uint32_t number : numbers)
        text::append_format(code_, "if jump == {} then goto N{} end ", number, number);
}

void LuaWriter::write_dispatcher() {
    code_ += code_.empty() ? "do return end ::computed:: " : " do return end ::computed:: ";
    write_number_dispatch(flow_.reachable());
    code_ += "no_target(jump)";
}

/// Lua has no jump into a loop. So at the end of its body a loop selects one of its own blocks; for any other
/// block it jumps to the structure around it.
void LuaWriter::write_loop_dispatcher() {
    const auto targets = flow_.loop_targets();
    if (!targets) return;
    text::append_format(code_, "goto {} ::{}:: ", targets->end, targets->label);
    write_number_dispatch(targets->numbers);
    text::append_format(code_, "goto {} ::{}:: ", targets->outer, targets->end);
}

}  // namespace gsim::codegen
