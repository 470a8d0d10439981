// Mandatory words of the codes of a block.

#include <string>

#include <fmt/format.h>

#include "codegen/blocks/block_plan.h"
#include "codegen/blocks/call_codes.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::Code;
using lexer::DiagnosticKind;
using lexer::Word;

namespace {

constexpr std::uint64_t kAxisBit = 1;
constexpr std::uint64_t kArcBit = 2;
constexpr std::uint64_t kProgramBit = 8;

}  // namespace

std::uint64_t BlockPlan::need_bits(const Word& word) const {
    if (word.address == 'P') return kProgramBit;
    if (is_axis(word)) return kAxisBit;
    return is_arc_word(word.address) ? kArcBit : 0;
}

/// In RS274/NGC a block that calls a program has no other action.
bool BlockPlan::check_single_call(const Block& block, const Call& call) {
    if (!lexer_.is_ngc() || (calls_.size() == 1 && block.assignments.empty())) return true;
    return fail(block, call.word, DiagnosticKind::code_conflict,
                "M98 stands in a block of its own, with nothing but its P and L");
}

bool BlockPlan::check_needs(const Block& block, const Call& call, std::uint64_t addresses) {
    const auto is_missing = [&](std::uint64_t bits) { return (addresses & bits) == 0; };
    if (call.kind == Call::Kind::via_point) {
        return !is_missing(kArcBit) || fail(block, call.word, DiagnosticKind::word_missing,
                                            "CIP needs a point on the way: I1=, J1= or K1=");
    }
    if (call.kind != Call::Kind::code) return true;
    const Code& code = *call.code;
    const auto name = [&] { return grammar::code_name(code); };
    if (code.code_x10 == 40 && code.letter == 'G' && call.operand_count != 1) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    lexer_.is_ngc() ? "G4 needs P, its seconds" : "G4 takes one of P, X and U, its seconds");
    }
    if (code.letter == 'G' && (code.code_x10 == 20 || code.code_x10 == 30) && is_missing(kArcBit) &&
        !is_missing(kAxisBit)) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    fmt::format("{} needs the centre (I, J, K){}", name(),
                                lexer_.is_ngc() ? " or the radius (R) of the arc"
                                                : ", the radius (R) or the angle (AR=) of the arc"));
    }
    if (code.letter == 'G' && (code.code_x10 == 920 || code.code_x10 == 520) && is_missing(kAxisBit)) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    fmt::format("{} needs the axis words whose coordinates it sets", name()));
    }
    const bool macro = code.letter == 'G' && code.code_x10 / 10 >= 65 && code.code_x10 / 10 <= 66;
    const bool call_code = code.letter == 'M' && code.code_x10 == kCallCode;
    if ((macro || call_code) && is_missing(kProgramBit)) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    fmt::format("{} needs P, the program that it calls", name()));
    }
    return !call_code || check_single_call(block, call);
}

bool BlockPlan::check_all_needs(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    needs_.assign(calls_.size(), 0);
    for (std::uint32_t call = 0; call < calls_.size(); ++call) {
        for (std::uint32_t word = 0; word < words.size(); ++word) {
            if (!belongs_to_call(block, word, call)) continue;
            needs_[call] |= need_bits(words[word]);
            ++calls_[call].operand_count;
        }
    }
    for (std::size_t i = 0; i < calls_.size(); ++i) {
        if (!check_needs(block, calls_[i], needs_[i])) return false;
    }
    return true;
}

}  // namespace gsim::codegen
