#include "codegen/blocks/block_plan.h"

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
using lexer::DiagnosticKind;
using lexer::Role;
using lexer::Word;

namespace {

bool is_corner_word(Address address) {
    return address >= lexer::kChamfer && address <= lexer::kLineAngle;
}

Phase address_phase(Address address) {
    switch (address) {
        case 'F': return Phase::feed;
        case 'S': return Phase::spindle_speed;
        case 'T': return Phase::tool;
        case lexer::kChamfer:
        case lexer::kCornerRadius:
        case lexer::kLineAngle: return Phase::one_shot;
        default: return Phase::offset_number;
    }
}

/// A macro call accepts I, J and K several times.
bool accepts_repeated(const Code* code, Address address) {
    return code != nullptr && address >= 'I' && address <= 'K' &&
           code->words.find('*') != std::string_view::npos;
}

AxisUse axis_use(const Call& call) {
    if (call.kind == Call::Kind::via_point) return AxisUse::motion;
    return call.code == nullptr ? AxisUse::none : call.code->axes;
}

std::string number_name(const Block& block, const Word& word) {
    return fmt::format("{}{}", static_cast<char>(word.address), block.text->view(word.number));
}

}  // namespace

char table_letter(Address address) {
    if (address == lexer::kArcAngle) return '=';
    if (address >= lexer::kViaX && address <= lexer::kViaZ) return '1';
    return static_cast<char>(address);
}

bool accepts(const Code& code, Address address) {
    return code.words.find(table_letter(address)) != std::string_view::npos;
}

std::string_view lua_key(Address address) {
    static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
    switch (address) {
        case lexer::kArcAngle: return "ar";
        case lexer::kViaX: return "i1";
        case lexer::kViaY: return "j1";
        case lexer::kViaZ: return "k1";
        case lexer::kPolarRadius: return "radius";
        case lexer::kPolarAngle: return "angle";
        case lexer::kSpindle: return "spindle";
        default: return kLetters.substr(static_cast<std::size_t>(address - 'A'), 1);
    }
}

bool BlockPlan::fail(const Block& block, std::uint32_t word, DiagnosticKind kind, const std::string& message,
                     const std::string& hint) {
    errors_.fail(block.text->words[word].column, kind, message, hint);
    return false;
}

bool BlockPlan::is_axis(const Word& word) const {
    if (lexer::is_axis_letter(word.address)) return true;
    const bool either = word.address == 'X' || word.address == 'U';
    return either && (!dialect_.text().ambiguous_words || word.role == Role::axis);
}

bool BlockPlan::is_allowed_with_move(Address address) const {
    return dialect_.rules().blocks.move_words.find(table_letter(address)) != std::string_view::npos;
}

bool BlockPlan::plan(const Block& block) {
    calls_.clear();
    operands_.clear();
    if (plan_axis_words(block) || plan_single_motion(block)) return true;
    axis_owner_ = kUnowned;
    unknown_word_.reset();
    skips_block_ = false;
    skips_words_ = false;
    if (!collect_codes(block)) return false;
    if (skips_block_) {  // what the block's words mean is not known without its code
        calls_.clear();
        return true;
    }
    if (unknown_word_) {
        Call call;
        call.kind = Call::Kind::unknown;
        call.word = *unknown_word_;
        calls_.assign(1, call);
        return true;
    }
    if (!choose_axis_owner(block) || !assign_words(block) || !check_all_required_words(block)) return false;
    gather_operands(block);
    drop_ineffective_one_shots(block);
    sort_calls();
    return true;
}

void BlockPlan::sort_calls() {
    if (calls_.size() < 2) return;
    std::stable_sort(calls_.begin(), calls_.end(), [&](const Call& a, const Call& b) {
        return dialect_.rank(a.phase) < dialect_.rank(b.phase);
    });
}

bool BlockPlan::check_group(const Block& block, const Code& code, std::uint32_t index) {
    for (const Call& call : calls_) {
        if (call.kind == Call::Kind::computed) continue;
        const bool motion = call.kind == Call::Kind::via_point;
        const Group group = motion ? Group::motion : call.code->group;
        const std::string other = motion ? "CIP" : grammar::code_name(*call.code);
        if (call.code == &code)
            return fail(block, index, DiagnosticKind::word_twice,
                        fmt::format("{} is given twice in the block", other));
        if (group != Group::none && group == code.group) {
            return fail(
                block, index, DiagnosticKind::code_conflict,
                fmt::format("{} and {} are in one modal group ({}); a block may have only one of them", other,
                            grammar::code_name(code), grammar::name(group)));
        }
    }
    return true;
}

/// Suggests a fix for a missing code.
std::string BlockPlan::hint(const Word& word) const {
    for (const grammar::Dialect* other : grammar::dialects()) {
        if (other->text().form != lexer::TextForm::blocks) continue;
        const Code* code = other->find(static_cast<char>(word.address), word.code_x10);
        if (other != &dialect_ && code != nullptr && code->group != Group::user)
            return fmt::format("{} supports it ({}), see --dialect {}", other->title(), code->meaning,
                               other->name());
    }
    const Code* base_code = dialect_.find(static_cast<char>(word.address), word.code_x10 / 10 * 10);
    return word.code_x10 > 0 && base_code != nullptr
               ? fmt::format("{} ({}) exists", grammar::code_name(*base_code), base_code->meaning)
               : "";
}

/// It acts in the phase of most codes without words: with the modal settings, or with the switches.
bool BlockPlan::add_computed_code(const Block& block, std::uint32_t index) {
    const Word& word = block.text->words[index];
    if (!dialect_.rules().blocks.computed_codes) {
        return fail(
            block, index, DiagnosticKind::code_unsupported,
            fmt::format("the number of a {} code must be a constant; a computed number is not supported",
                        static_cast<char>(word.address)));
    }
    Call call;
    call.kind = Call::Kind::computed;
    call.phase = word.address == 'G' ? Phase::work_frame : Phase::pause;
    call.word = index;
    calls_.push_back(call);
    return true;
}

bool BlockPlan::add_code(const Block& block, std::uint32_t index) {
    const Word& word = block.text->words[index];
    if (word.expression >= 0) return add_computed_code(block, index);
    const Code* code = dialect_.find(static_cast<char>(word.address), word.code_x10);
    if (code == nullptr) {
        const std::string name = number_name(block, word);
        if (unknown_ != nullptr) {
            unknown_->add(name, block.text->at(word.column));
            skips_block_ |= word.address == 'G';
            skips_words_ = true;
            return true;
        }
        if (deferred_codes_ != nullptr) {
            deferred_codes_->add(name, block.text->at(word.column));
            unknown_word_ = index;
            return true;
        }
        return fail(block, index, DiagnosticKind::code_unknown,
                    fmt::format("{} is not a code of {}", name, dialect_.title()), hint(word));
    }
    if (code->support == Support::planned) {
        return fail(block, index, DiagnosticKind::code_unsupported,
                    fmt::format("{} ({}) is not supported", grammar::code_name(*code), code->meaning));
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
        if (address == lexer::kIntermediatePoint) {
            for (const Call& other : calls_) {
                const bool motion = other.kind == Call::Kind::via_point || other.code->group == Group::motion;
                if (motion)
                    return fail(block, i, DiagnosticKind::code_conflict,
                                "CIP is given with another motion code; a block may have only one of them");
            }
            Call call;
            call.kind = Call::Kind::via_point;
            call.word = i;
            calls_.push_back(call);
        }
    }
    return true;
}

/// Returns true if two calls that use axis words cannot share a block: two codes that have them as their
/// data, and with BlockRules::data_excludes_motion such a code and a motion, except for the tool offset of
/// a block without axis words.
bool BlockPlan::report_conflict(const Block& block, const Call& a, const Call& b) const {
    const bool is_a_data = axis_use(a) == AxisUse::data, b_is_data = axis_use(b) == AxisUse::data;
    if (is_a_data && b_is_data) return true;
    if (!dialect_.rules().blocks.data_excludes_motion) return false;
    const std::vector<Word>& words = block.text->words;
    return (is_a_data ? a : b).code->group != Group::tool_length ||
           std::any_of(words.begin(), words.end(), [&](const Word& word) { return is_axis(word); });
}

/// Selects the call that receives the axis words: a code that has them as its data, else the motion.
bool BlockPlan::choose_axis_owner(const Block& block) {
    for (std::uint32_t i = 0; i < calls_.size(); ++i) {
        const Call& call = calls_[i];
        if (axis_use(call) == AxisUse::none) continue;
        if (axis_owner_ != kUnowned) {
            const Call& owner = calls_[static_cast<std::size_t>(axis_owner_)];
            if (report_conflict(block, owner, call)) {
                return fail(block, call.word, DiagnosticKind::code_conflict,
                            fmt::format("{} and {} both use the axis words of the block",
                                        grammar::code_name(*owner.code), grammar::code_name(*call.code)));
            }
        }
        if (axis_owner_ == kUnowned || axis_use(call) == AxisUse::data)
            axis_owner_ = static_cast<std::int32_t>(i);
    }
    return true;
}

/// Returns the call that a word belongs to by its role and letter; -1: no call of the block.
std::int32_t BlockPlan::find_owner(const Word& word) const {
    if (is_axis(word)) return axis_owner_;
    if (word.role == Role::time || word.role == Role::program) {
        const Group requested = word.role == Role::program ? Group::subprogram : Group::none;
        for (std::size_t i = 0; i < calls_.size(); ++i) {
            const Code* code = calls_[i].code;
            if (code != nullptr && code->group == requested && accepts(*code, word.address))
                return static_cast<std::int32_t>(i);
        }
        return kUnowned;
    }
    for (std::size_t i = 0; i < calls_.size(); ++i) {
        const bool via = calls_[i].kind == Call::Kind::via_point && word.address != 'R' &&
                         word.address != lexer::kArcAngle && is_arc_word(word.address);
        if (via || (calls_[i].code != nullptr && accepts(*calls_[i].code, word.address)))
            return static_cast<std::int32_t>(i);
    }
    const bool modal =
        axis_owner_ != kUnowned && calls_[static_cast<std::size_t>(axis_owner_)].kind == Call::Kind::move;
    return modal && is_allowed_with_move(word.address) ? axis_owner_ : kUnowned;
}

/// ,C ,R and ,A belong to the modal motion or to a code that accepts them.
bool BlockPlan::may_have_corner() const {
    if (axis_owner_ == kUnowned) return true;
    const Code* code = calls_[static_cast<std::size_t>(axis_owner_)].code;
    return code == nullptr || code->words.find(',') != std::string_view::npos;
}

bool BlockPlan::fail_with_motion(const Block& block, std::uint32_t index) {
    const Code* code = calls_[static_cast<std::size_t>(axis_owner_)].code;
    return fail(block, index, DiagnosticKind::word_out_of_place,
                fmt::format("{} has no meaning in a block with {}",
                            lexer::address_name(block.text->words[index].address),
                            code == nullptr ? "CIP" : grammar::code_name(*code)));
}

/// Returns true if words define the target of a move; P, L or Q alone do not.
bool BlockPlan::has_target(const Block& block) const {
    const std::vector<Word>& words = block.text->words;
    return std::any_of(words.begin(), words.end(),
                       [&](const Word& word) { return is_axis(word) || is_arc_word(word.address); });
}

bool BlockPlan::assign(const Block& block, std::uint32_t index) {
    const Word& word = block.text->words[index];
    owners_[index] = find_owner(word);
    if (owners_[index] != kUnowned) return true;
    if (is_corner_word(word.address) && !may_have_corner()) return fail_with_motion(block, index);
    const bool standalone =
        dialect_.rules().blocks.standalone.find(table_letter(word.address)) != std::string_view::npos;
    if (standalone || is_corner_word(word.address)) {
        Call call;
        call.kind = Call::Kind::letter;
        call.phase = address_phase(word.address);
        call.word = index;
        calls_.push_back(call);
        return true;
    }
    const bool has_motion = axis_owner_ != kUnowned;
    if (has_motion && is_allowed_with_move(word.address)) return fail_with_motion(block, index);
    if (!is_axis(word) && skips_words_) return true;
    const bool moves = is_axis(word) || (is_allowed_with_move(word.address) && has_target(block));
    if (!moves) {
        return fail(block, index, DiagnosticKind::word_out_of_place,
                    fmt::format("{} has no meaning in this block: no code of the block uses it",
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
        const bool twice = seen[address];
        seen[address] = true;
        if (!assign(block, i)) return false;
        const Code* owner =
            owners_[i] == kUnowned ? nullptr : calls_[static_cast<std::size_t>(owners_[i])].code;
        if (twice && !accepts_repeated(owner, address))
            return fail(block, i, DiagnosticKind::word_twice,
                        fmt::format("{} is given twice in the block", lexer::address_name(address)));
    }
    const bool corner = std::any_of(words.begin(), words.end(),
                                    [](const Word& word) { return is_corner_word(word.address); });
    if (corner && axis_owner_ == kUnowned) {  // ,A alone: the modal motion continues in that direction
        Call call;
        call.word = 0;
        axis_owner_ = static_cast<std::int32_t>(calls_.size());
        calls_.push_back(call);
    }
    return true;
}

/// G53 and G09 modify the move of their block; without one they must not wait for the next block's.
void BlockPlan::drop_ineffective_one_shots(const Block& block) {
    if (axis_owner_ != kUnowned) return;
    std::erase_if(calls_, [&](const Call& call) {
        if (call.phase != Phase::one_shot || call.kind != Call::Kind::code) return false;
        diagnostics_.warning(
            block.text->at(block.text->words[call.word].column), DiagnosticKind::code_idle,
            fmt::format("{} has no effect in a block without a move", grammar::code_name(*call.code)));
        return true;
    });
}

}  // namespace gsim::codegen
