// Words of the calls of a block: those that belong to each of them, and those that it requires.

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "codegen/blocks/block_plan.h"
#include "codegen/blocks/call_codes.h"

namespace gsim::codegen {

using grammar::Block;
using grammar::Code;
using lexer::DiagnosticKind;
using lexer::Word;

namespace {

/// Words that arcs and cycles read and other codes of RS274/NGC read too.
constexpr std::string_view kModalMotionLetters = "LPQR";

constexpr std::uint64_t kAxisBit = 1;
constexpr std::uint64_t kArcBit = 2;
constexpr std::uint64_t kProgramBit = 8;

/// Returns the error of a G4 without its time, for one or more letters that give it.
std::string dwell_message(std::string_view letters) {
    if (letters.size() == 1) return fmt::format("G4 requires {}, the time in seconds", letters);
    return fmt::format("G4 requires one of {}, the time in seconds", text::enumerated(letters, "and"));
}

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

std::uint64_t BlockPlan::required_word_bits(const Word& word) const {
    if (word.address == 'P') return kProgramBit;
    if (is_axis(word)) return kAxisBit;
    return is_arc_word(word.address) ? kArcBit : 0;
}

bool BlockPlan::check_single_call(const Block& block, const Call& call) {
    if (!dialect_.rules().blocks.separate_calls || (calls_.size() == 1 && block.assignments.empty()))
        return true;
    return fail(block, call.word, DiagnosticKind::code_conflict,
                "M98 must be in a separate block, only with its P and L");
}

bool BlockPlan::check_required_words(const Block& block, const Call& call, std::uint64_t addresses) {
    const auto is_missing = [&](std::uint64_t bits) { return (addresses & bits) == 0; };
    if (call.kind == Call::Kind::via_point) {
        return !is_missing(kArcBit) || fail(block, call.word, DiagnosticKind::word_missing,
                                            "CIP requires an intermediate point: I1=, J1= or K1=");
    }
    if (call.kind != Call::Kind::code) return true;
    const Code& code = *call.code;
    const auto name = [&] { return grammar::code_name(code); };
    if (code.code_x10 == 40 && code.letter == 'G' && call.operand_count != 1) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    dwell_message(dialect_.rules().blocks.dwell_words));
    }
    if (code.letter == 'G' && (code.code_x10 == 20 || code.code_x10 == 30) && is_missing(kArcBit) &&
        !is_missing(kAxisBit)) {
        return fail(
            block, call.word, DiagnosticKind::word_missing,
            fmt::format("{} requires the centre (I, J, K){}", name(),
                        accepts(code, lexer::kArcAngle) ? ", the radius (R) or the angle (AR=) of the arc"
                                                        : " or the radius (R) of the arc"));
    }
    if (code.letter == 'G' && (code.code_x10 == 920 || code.code_x10 == 520) && is_missing(kAxisBit)) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    fmt::format("{} requires the axis words whose coordinates it sets", name()));
    }
    const bool macro = code.letter == 'G' && code.code_x10 / 10 >= 65 && code.code_x10 / 10 <= 66;
    const bool call_code = code.letter == 'M' && code.code_x10 == kCallCode;
    if ((macro || call_code) && is_missing(kProgramBit)) {
        return fail(block, call.word, DiagnosticKind::word_missing,
                    fmt::format("{} requires P, the program that it calls", name()));
    }
    return !call_code || check_single_call(block, call);
}

bool BlockPlan::check_all_required_words(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    word_bits_.assign(calls_.size(), 0);
    for (std::uint32_t call = 0; call < calls_.size(); ++call) {
        for (std::uint32_t word = 0; word < words.size(); ++word) {
            if (!belongs_to_call(block, word, call)) continue;
            word_bits_[call] |= required_word_bits(words[word]);
            ++calls_[call].operand_count;
        }
    }
    for (std::size_t i = 0; i < calls_.size(); ++i) {
        if (!check_required_words(block, calls_[i], word_bits_[i])) return false;
    }
    return true;
}

}  // namespace gsim::codegen
