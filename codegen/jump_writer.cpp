// The part of LuaWriter that writes jumps and notes calls: GOTO, M99 P, M98.

#include <charconv>
#include <iterator>

#include <fmt/format.h>

#include "codegen/expression_writer.h"
#include "codegen/lua_writer.h"
#include "codegen/word_writer.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::Node;
using grammar::NodeKind;
using lexer::Word;

namespace {

constexpr std::size_t kMaxCalledPrograms = 10000;

}  // namespace

/// M99 P in the main program goes on at a block of it. False where there is no P.
bool LuaWriter::write_goto_of_return(const Block& block, const Call& call) {
    if (call.operand_count == 0 || lexer_.is_ngc()) return false;
    const Word& word = block.text->words[plan_.operands(call).front()];
    if (word.expression >= 0) {
        code_ += "jump = goto_target(";
        write_number(block, word.expression, code_);
        code_ += ") goto computed ";
    } else if (const auto target = block_number(block, word.number, word.column)) {
        flow_.add_jump(*target, block.text->at(word.column));
        fmt::format_to(std::back_inserter(code_), "goto N{} ", *target);
    }
    return true;
}

/// The number of a block that a jump leads to, or nothing where the error was reported.
std::optional<std::uint32_t> LuaWriter::block_number(const Block& block, lexer::Slice digits_slice,
                                                     std::uint32_t column) {
    const std::string_view digits = block.text->view(digits_slice);
    const std::string number = all_digits(digits) ? normal_number(digits) : "";
    std::uint32_t value = 0;
    if (number.empty() || number.size() > 9) {
        lexer_.fail(column, fmt::format("a jump leads to a block number, not to {}", digits));
        return std::nullopt;
    }
    std::from_chars(number.data(), number.data() + number.size(), value);
    return value;
}

void LuaWriter::note_call(const Block& block, const Call& call) {
    for (const std::uint32_t index : plan_.operands(call)) {
        const Word& word = block.text->words[index];
        if (word.expression >= 0) continue;
        const std::string_view digits = block.text->view(word.number);
        const std::string number = all_digits(digits) ? normal_number(digits) : "";
        if (number.empty() || number.size() > 9) {
            lexer_.fail(word.column, fmt::format("{} of M98 is a whole number, not {}",
                                                 lexer::address_name(word.address), digits));
            return;
        }
        std::uint32_t value = 0;
        std::from_chars(number.data(), number.data() + number.size(), value);
        if (word.address == 'P' && called_.size() < kMaxCalledPrograms)
            called_.try_emplace(value, block.text->at(word.column));
    }
}

void LuaWriter::write_goto(const Block& block) {
    const Node& target = block.node(block.target);
    if (target.kind != NodeKind::number) {
        code_ += "jump = goto_target(";
        write_number(block, block.target, code_);
        code_ += ") goto computed";
        return;
    }
    const auto number = block_number(block, target.number, block.target_column);
    if (!number) return;
    flow_.add_jump(*number, block.text->at(block.target_column));
    fmt::format_to(std::back_inserter(code_), "goto N{}", *number);
}

void LuaWriter::write_dispatcher() {
    code_ += code_.empty() ? "do return end ::computed:: " : " do return end ::computed:: ";
    for (const std::uint32_t number : flow_.reachable()) {
        fmt::format_to(std::back_inserter(code_), "if jump == {} then goto N{} end ", number, number);
    }
    code_ += "no_target(jump)";
}

}  // namespace gsim::codegen
