#include "codegen/block_plan.h"

#include <algorithm>
#include <bitset>
#include <string>

#include <fmt/format.h>

namespace gsim::codegen {

using grammar::AxisUse;
using grammar::Block;
using grammar::Code;
using grammar::Group;
using grammar::Phase;
using grammar::Support;
using lexer::Address;
using lexer::Role;
using lexer::Word;

namespace {

constexpr std::int32_t kUnowned = -1;

bool is_axis(const Word& word) {
    switch (word.address) {
        case 'A':
        case 'B':
        case 'C':
        case 'V':
        case 'W':
        case 'Y':
        case 'Z': return true;
        case 'X':
        case 'U': return word.role == Role::axis;
        default: return false;
    }
}

bool is_arc_word(Address address) {
    return (address >= 'I' && address <= 'K') || address == 'R' ||
           (address >= lexer::kArcAngle && address <= lexer::kViaZ);
}

bool stands_alone(Address address) {
    return address == 'F' || address == 'S' || address == 'T' || address == 'D' || address == 'H';
}

Phase phase_of(Address address) {
    switch (address) {
        case 'F': return Phase::feed;
        case 'S': return Phase::spindle_speed;
        case 'T': return Phase::tool;
        default: return Phase::offset_number;
    }
}

bool takes(const Code& code, Address address) {
    char letter = static_cast<char>(address);
    if (address == lexer::kArcAngle) letter = '=';
    if (address >= lexer::kViaX && address <= lexer::kViaZ) letter = '1';
    return code.words.find(letter) != std::string_view::npos;
}

std::string number_name(const Block& block, const Word& word) {
    return fmt::format("{}{}", static_cast<char>(word.address), block.text->view(word.number));
}

constexpr std::uint64_t kAxisBit = 1;
constexpr std::uint64_t kArcBit = 2;
constexpr std::uint64_t kTimeBit = 4;
constexpr std::uint64_t kProgramBit = 8;

std::uint64_t need_bits(const Word& word) {
    if (word.role == Role::time) return kTimeBit;
    if (word.role == Role::program) return kProgramBit;
    if (is_axis(word)) return kAxisBit;
    return is_arc_word(word.address) ? kArcBit : 0;
}

}  // namespace

std::string_view lua_key(Address address) {
    static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
    switch (address) {
        case lexer::kArcAngle: return "ar";
        case lexer::kViaX: return "i1";
        case lexer::kViaY: return "j1";
        case lexer::kViaZ: return "k1";
        default: return kLetters.substr(static_cast<std::size_t>(address - 'A'), 1);
    }
}

bool BlockPlan::fail(const Block& block, std::uint32_t word, const std::string& message) {
    lexer_.fail(block.text->words[word].column, message);
    return false;
}

bool BlockPlan::plan(const Block& block) {
    calls_.clear();
    operands_.clear();
    if (only_moves(block)) return true;
    axis_owner_ = kUnowned;
    if (!collect_codes(block) || !choose_axis_owner(block) || !assign_words(block) || !check_all_needs(block))
        return false;
    gather_operands();
    drop_idle_one_shots(block);
    std::stable_sort(calls_.begin(), calls_.end(),
                     [](const Call& a, const Call& b) { return a.phase < b.phase; });
    return true;
}

/// The common block of a tool path, axis words alone, without the machinery of the rest.
bool BlockPlan::only_moves(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    std::uint64_t seen = 0;
    for (const Word& word : words) {
        const std::uint64_t bit = std::uint64_t{1} << (word.address & 63U);
        if (!is_axis(word) || (seen & bit) != 0) return false;
        seen |= bit;
    }
    if (words.empty()) return true;
    for (std::uint32_t i = 0; i < words.size(); ++i) operands_.push_back(i);
    Call call;
    call.operand_count = static_cast<std::uint32_t>(words.size());
    calls_.push_back(call);
    return true;
}

bool BlockPlan::check_group(const Block& block, const Code& code, std::uint32_t index) {
    for (const Call& call : calls_) {
        const bool motion = call.kind == Call::Kind::via_point;
        const Group group = motion ? Group::motion : call.code->group;
        const std::string other = motion ? "CIP" : grammar::code_name(*call.code);
        if (call.code == &code) return fail(block, index, fmt::format("{} stands twice in the block", other));
        if (group != Group::none && group == code.group) {
            return fail(block, index,
                        fmt::format("{} and {} are of one modal group ({}); a block takes one of them", other,
                                    grammar::code_name(code), grammar::name(group)));
        }
    }
    return true;
}

bool BlockPlan::add_code(const Block& block, std::uint32_t index) {
    const Word& word = block.text->words[index];
    if (word.expression >= 0) {
        return fail(
            block, index,
            fmt::format("the number of a {} code must be written out; a computed one is not supported",
                        static_cast<char>(word.address)));
    }
    const Code* code = dialect_.find(static_cast<char>(word.address), word.code_x10);
    if (code == nullptr) {
        return fail(
            block, index,
            fmt::format("{} is no code of the {} dialect", number_name(block, word), dialect_.title()));
    }
    if (code->support == Support::later) {
        return fail(block, index,
                    fmt::format("{} ({}) is not supported yet", grammar::code_name(*code), code->meaning));
    }
    if (!check_group(block, *code, index)) return false;
    Call call;
    call.kind = Call::Kind::code;
    call.phase = code->phase;
    call.code = code;
    call.word = index;
    calls_.push_back(call);
    return true;
}

bool BlockPlan::collect_codes(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    for (std::uint32_t i = 0; i < words.size(); ++i) {
        const Address address = words[i].address;
        if ((address == 'G' || address == 'M') && !add_code(block, i)) return false;
        if (address == lexer::kComma)
            return fail(block, i, "chamfers, corner radii and angles (,C ,R ,A) are not supported yet");
        if (address == lexer::kIntermediatePoint) {
            for (const Call& other : calls_) {
                const bool motion = other.kind == Call::Kind::via_point || other.code->group == Group::motion;
                if (motion)
                    return fail(block, i, "CIP stands with another motion code; a block takes one of them");
            }
            Call call;
            call.kind = Call::Kind::via_point;
            call.word = i;
            calls_.push_back(call);
        }
    }
    return true;
}

/// The call that takes the axis words: a code that has them as its data, else the motion.
bool BlockPlan::choose_axis_owner(const Block& block) {
    for (std::uint32_t i = 0; i < calls_.size(); ++i) {
        const Call& call = calls_[i];
        const bool data = call.code != nullptr && call.code->axes == AxisUse::data;
        const bool motion = call.kind == Call::Kind::via_point ||
                            (call.code != nullptr && call.code->axes == AxisUse::motion);
        if (!data && !motion) continue;
        const bool owner_has_data = axis_owner_ != kUnowned &&
                                    calls_[static_cast<std::size_t>(axis_owner_)].code != nullptr &&
                                    calls_[static_cast<std::size_t>(axis_owner_)].code->axes == AxisUse::data;
        if (data && owner_has_data) {
            return fail(block, call.word,
                        fmt::format("{} and {} both take the axis words of the block",
                                    grammar::code_name(*calls_[static_cast<std::size_t>(axis_owner_)].code),
                                    grammar::code_name(*call.code)));
        }
        if (axis_owner_ == kUnowned || data) axis_owner_ = static_cast<std::int32_t>(i);
    }
    return true;
}

/// The call that a word belongs to by its role and letter; -1: none of those that stand in the block.
std::int32_t BlockPlan::owner_of(const Word& word) const {
    if (is_axis(word)) return axis_owner_;
    if (word.role == Role::time || word.role == Role::program) {
        const Group wanted = word.role == Role::program ? Group::subprogram : Group::none;
        for (std::size_t i = 0; i < calls_.size(); ++i) {
            const Code* code = calls_[i].code;
            if (code != nullptr && code->group == wanted && takes(*code, word.address))
                return static_cast<std::int32_t>(i);
        }
        return kUnowned;
    }
    for (std::size_t i = 0; i < calls_.size(); ++i) {
        const bool via = calls_[i].kind == Call::Kind::via_point && word.address != 'R' &&
                         word.address != lexer::kArcAngle && is_arc_word(word.address);
        if (via || (calls_[i].code != nullptr && takes(*calls_[i].code, word.address)))
            return static_cast<std::int32_t>(i);
    }
    const bool modal =
        axis_owner_ != kUnowned && calls_[static_cast<std::size_t>(axis_owner_)].kind == Call::Kind::move;
    return modal && is_arc_word(word.address) ? axis_owner_ : kUnowned;
}

bool BlockPlan::assign(const Block& block, std::uint32_t index) {
    const Word& word = block.text->words[index];
    owners_[index] = owner_of(word);
    if (owners_[index] != kUnowned) return true;
    if (stands_alone(word.address)) {
        Call call;
        call.kind = Call::Kind::letter;
        call.phase = phase_of(word.address);
        call.word = index;
        calls_.push_back(call);
        return true;
    }
    const bool motion_given = axis_owner_ != kUnowned;
    if (motion_given && is_arc_word(word.address)) {
        const Code* code = calls_[static_cast<std::size_t>(axis_owner_)].code;
        return fail(block, index,
                    fmt::format("{} has no meaning in a block with {}", lexer::address_name(word.address),
                                code == nullptr ? "CIP" : grammar::code_name(*code)));
    }
    if (!is_axis(word) && !is_arc_word(word.address)) {
        return fail(block, index,
                    fmt::format("{} has no meaning in this block: no code of the block takes it",
                                lexer::address_name(word.address)));
    }
    Call call;
    call.word = index;
    axis_owner_ = static_cast<std::int32_t>(calls_.size());
    calls_.push_back(call);
    owners_[index] = axis_owner_;
    return true;
}

bool BlockPlan::assign_words(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    std::bitset<256> seen;
    owners_.assign(words.size(), kUnowned);
    for (std::uint32_t i = 0; i < words.size(); ++i) {
        const Address address = words[i].address;
        if (address == 'G' || address == 'M' || address == lexer::kIntermediatePoint) continue;
        if (seen[address])
            return fail(block, i, fmt::format("{} stands twice in the block", lexer::address_name(address)));
        seen[address] = true;
        if (!assign(block, i)) return false;
    }
    return true;
}

bool BlockPlan::check_needs(const Block& block, const Call& call, std::uint64_t addresses) {
    const auto lacks = [&](std::uint64_t bits) { return (addresses & bits) == 0; };
    if (call.kind == Call::Kind::via_point) {
        return !lacks(kArcBit) || fail(block, call.word, "CIP needs a point on the way: I1=, J1= or K1=");
    }
    if (call.kind != Call::Kind::code) return true;
    const Code& code = *call.code;
    const std::string name = grammar::code_name(code);
    if (code.code_x10 == 40 && code.letter == 'G' && call.operand_count != 1) {
        return fail(block, call.word, "G4 takes one of P, X and U, its seconds");
    }
    if (code.letter == 'G' && (code.code_x10 == 20 || code.code_x10 == 30) && lacks(kArcBit) &&
        !lacks(kAxisBit)) {
        return fail(
            block, call.word,
            fmt::format("{} needs the centre (I, J, K), the radius (R) or the angle (AR=) of the arc", name));
    }
    if (code.letter == 'G' && (code.code_x10 == 920 || code.code_x10 == 520) && lacks(kAxisBit)) {
        return fail(block, call.word, fmt::format("{} needs the axis words whose coordinates it sets", name));
    }
    if (code.letter == 'M' && code.code_x10 == 980 && lacks(kProgramBit)) {
        return fail(block, call.word, "M98 needs P, the program that it calls");
    }
    if (code.letter == 'M' && code.code_x10 == 990 && !lacks(kProgramBit)) {
        return fail(block, call.word, "M99 with P (return to a block) is not supported yet");
    }
    if (code.support == Support::bare_only && call.operand_count > 0) {
        return fail(block, call.word, fmt::format("{} ({}) is not supported yet", name, code.meaning));
    }
    return true;
}

bool BlockPlan::check_all_needs(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    std::vector<std::uint64_t> bits(calls_.size(), 0);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (owners_[i] == kUnowned) continue;
        const auto owner = static_cast<std::size_t>(owners_[i]);
        bits[owner] |= need_bits(words[i]);
        ++calls_[owner].operand_count;
    }
    for (std::size_t i = 0; i < calls_.size(); ++i) {
        if (!check_needs(block, calls_[i], bits[i])) return false;
    }
    return true;
}

void BlockPlan::gather_operands() {
    for (std::uint32_t c = 0; c < calls_.size(); ++c) {
        calls_[c].first_operand = static_cast<std::uint32_t>(operands_.size());
        for (std::uint32_t i = 0; i < owners_.size(); ++i) {
            if (owners_[i] == static_cast<std::int32_t>(c)) operands_.push_back(i);
        }
    }
}

/// G53 and G09 say how the move of their block is made; without one they must not wait for the next block's.
void BlockPlan::drop_idle_one_shots(const Block& block) {
    if (axis_owner_ != kUnowned) return;
    std::erase_if(calls_, [&](const Call& call) {
        if (call.phase != Phase::one_shot) return false;
        diagnostics_.warning(
            block.text->at(block.text->words[call.word].column),
            fmt::format("{} does nothing in a block without a move", grammar::code_name(*call.code)));
        return true;
    });
}

}  // namespace gsim::codegen
