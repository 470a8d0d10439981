// Assignment of the words of a block to its calls.

#include <string_view>

#include "codegen/blocks/block_plan.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::Code;
using lexer::Word;

namespace {

/// Words that arcs and cycles read and other codes of RS274/NGC read too.
constexpr std::string_view kModalMotionLetters = "LPQR";

}  // namespace

/// Shared words belong to every code that reads them: in `G64 P2 M19 R90` of RS274/NGC P is the tolerance and
/// the direction.
bool BlockPlan::belongs_to_call(const Block& block, std::uint32_t word, std::uint32_t call) const {
    if (owners_[word] == static_cast<std::int32_t>(call)) return true;
    const Word& shared = block.text->words[word];
    const Code* code = calls_[call].code;
    return dialect_.rules().blocks.shared_words && owners_[word] != kUnowned && code != nullptr &&
           !is_axis(shared) && accepts(*code, shared.address);
}

/// The modal motion is known only at run time. So it is not known before if this word, which arcs and cycles
/// read, belongs to it.
bool BlockPlan::is_shared(const Block& block, std::uint32_t word, std::uint32_t call) const {
    const Word& shared = block.text->words[word];
    return dialect_.rules().blocks.shared_words && calls_[call].kind == Call::Kind::move &&
           owners_[word] != kUnowned &&
           kModalMotionLetters.find(table_letter(shared.address)) != std::string_view::npos &&
           !belongs_to_call(block, word, call);
}

void BlockPlan::gather_operands(const Block& block) {
    for (std::uint32_t c = 0; c < calls_.size(); ++c) {
        calls_[c].first_operand = static_cast<std::uint32_t>(operands_.size());
        for (std::uint32_t i = 0; i < owners_.size(); ++i) {
            if (belongs_to_call(block, i, c)) operands_.push_back(i);
        }
        calls_[c].operand_count = static_cast<std::uint32_t>(operands_.size()) - calls_[c].first_operand;
        for (std::uint32_t i = 0; i < owners_.size(); ++i) {
            if (is_shared(block, i, c)) operands_.push_back(i);
        }
        calls_[c].shared_count =
            static_cast<std::uint32_t>(operands_.size()) - calls_[c].first_operand - calls_[c].operand_count;
    }
}

}  // namespace gsim::codegen
