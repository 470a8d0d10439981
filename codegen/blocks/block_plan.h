#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codegen/blocks/unknown_codes.h"
#include "grammar/dialect.h"
#include "grammar/syntax.h"
#include "lexer/block_errors.h"

namespace gsim::codegen {

/// Call of a library function that a block becomes.
struct Call {
    enum class Kind : std::uint8_t {
        code,       ///< A G or M code.
        letter,     ///< F, S, T, D or H by itself; ,C ,R or ,A.
        move,       ///< Axis words that go on with the modal motion.
        via_point,  ///< CIP
        unknown,    ///< Code missing in the dialect, if it is deferred; alone in its block.
        computed,   ///< RS274/NGC: a G or M code without words with its number known at run time.
    };
    Kind kind = Kind::move;
    grammar::Phase phase = grammar::Phase::motion;
    const grammar::Code* code = nullptr;  ///< For Kind::code.
    std::uint32_t word = 0;               ///< The word that asked for the call.
    std::uint32_t first_operand = 0;      ///< Into BlockPlan::operands().
    std::uint32_t operand_count = 0;
    /// Words that follow them: used by another code of the block, and available to the modal motion too.
    std::uint32_t shared_count = 0;
};

/// Plan of a block: decides which code uses which word, which words are missing, extra, double or
/// contradictory, and the order in which the controller executes them.
class BlockPlan {
  public:
    /// Makes a plan; all arguments must outlive it. Codes that the dialect does not have are passed to
    /// `unknown`, if given, and are left out; else they are errors.
    BlockPlan(const grammar::Dialect& dialect, lexer::BlockErrors& errors, lexer::Diagnostics& diagnostics,
              UnknownCodes* unknown)
        : dialect_(dialect), errors_(errors), diagnostics_(diagnostics), unknown_(unknown) {}

    const grammar::Dialect& dialect() const { return dialect_; }
    /// Defers codes that the dialect does not have: from here on such a code becomes an alarm of the run
    /// (Kind::unknown), with a warning. The blocks are those of a subroutine, which may never be called.
    void defer_unknown(UnknownCodes* deferred) { deferred_codes_ = deferred; }

    /// Plans one block of words. Returns false if an error was reported. Valid until the next call.
    bool plan(const grammar::Block& block);

    std::span<const Call> calls() const { return calls_; }
    /// Returns the word indices of a call's operands.
    std::span<const std::uint32_t> operands(const Call& call) const {
        return std::span(operands_).subspan(call.first_operand, call.operand_count);
    }
    /// Returns the word indices that a call of the modal motion shares with other codes.
    std::span<const std::uint32_t> shared(const Call& call) const {
        return std::span(operands_).subspan(call.first_operand + call.operand_count, call.shared_count);
    }

  private:
    static constexpr std::int32_t kUnowned = -1;

    bool is_axis(const lexer::Word& word) const;
    std::string hint(const lexer::Word& word) const;
    std::uint64_t required_word_bits(const lexer::Word& word) const;
    bool is_allowed_with_move(lexer::Address address) const;
    bool plan_axis_words(const grammar::Block& block);
    bool plan_single_motion(const grammar::Block& block);
    void add_single_call(const Call& call, std::uint32_t first_operand, std::size_t words);
    bool collect_codes(const grammar::Block& block);
    bool add_code(const grammar::Block& block, std::uint32_t index);
    bool add_computed_code(const grammar::Block& block, std::uint32_t index);
    bool check_group(const grammar::Block& block, const grammar::Code& code, std::uint32_t index);
    bool report_conflict(const grammar::Block& block, const Call& a, const Call& b) const;
    bool choose_axis_owner(const grammar::Block& block);
    bool assign_words(const grammar::Block& block);
    bool belongs_to_call(const grammar::Block& block, std::uint32_t word, std::uint32_t call) const;
    bool is_shared(const grammar::Block& block, std::uint32_t word, std::uint32_t call) const;
    bool may_have_corner() const;
    bool has_target(const grammar::Block& block) const;
    bool fail_with_motion(const grammar::Block& block, std::uint32_t index);
    bool assign(const grammar::Block& block, std::uint32_t index);
    std::int32_t find_owner(const lexer::Word& word) const;
    bool check_required_words(const grammar::Block& block, const Call& call, std::uint64_t addresses);
    bool check_all_required_words(const grammar::Block& block);
    bool check_single_call(const grammar::Block& block, const Call& call);
    void gather_operands(const grammar::Block& block);
    void sort_calls();
    void drop_ineffective_one_shots(const grammar::Block& block);
    bool fail(const grammar::Block& block, std::uint32_t word, lexer::DiagnosticKind kind,
              const std::string& message, const std::string& hint = {});

    const grammar::Dialect& dialect_;
    lexer::BlockErrors& errors_;
    lexer::Diagnostics& diagnostics_;
    UnknownCodes* unknown_;
    UnknownCodes* deferred_codes_ = nullptr;
    std::optional<std::uint32_t> unknown_word_;
    bool skips_block_ = false;  ///< A G code that is left out: with it all of its block.
    bool skips_words_ = false;  ///< An M code that is left out, with words that no other code uses.
    std::vector<Call> calls_;
    std::vector<std::uint32_t> operands_;
    std::vector<std::int32_t> owners_;      // by word: index of its call, or -1
    std::vector<std::uint64_t> word_bits_;  // by call: required_word_bits() of its words
    std::int32_t axis_owner_ = -1;
};

/// Returns the letter of an address as the dialect's table writes it.
char table_letter(lexer::Address address);
/// Returns true if words with this address belong to the code.
bool accepts(const grammar::Code& code, lexer::Address address);

/// Returns true for the centre, radius or angle of an arc, or the point of CIP on it.
constexpr bool is_arc_word(lexer::Address address) {
    return (address >= 'I' && address <= 'K') || address == 'R' ||
           (address >= lexer::kArcAngle && address <= lexer::kViaZ);
}

/// Returns the key of an operand in the table for a library function: "x", "ar", "i1", "radius" for @.
std::string_view lua_key(lexer::Address address);

}  // namespace gsim::codegen
