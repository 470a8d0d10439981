#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grammar/dialect.h"
#include "grammar/syntax.h"
#include "lexer/lexer.h"

namespace gsim::codegen {

/// One call of a library function that a block becomes.
struct Call {
    enum class Kind : std::uint8_t {
        code,       ///< A G or M code.
        letter,     ///< F, S, T, D or H by itself.
        move,       ///< Axis words that go on with the modal motion.
        via_point,  ///< CIP
    };
    Kind kind = Kind::move;
    grammar::Phase phase = grammar::Phase::motion;
    const grammar::Code* code = nullptr;  ///< Of Kind::code.
    std::uint32_t word = 0;               ///< The word that asked for the call.
    std::uint32_t first_operand = 0;      ///< Into BlockPlan::operands().
    std::uint32_t operand_count = 0;
};

/// Decides what the words of a block mean together: which code takes which word, what is missing, extra,
/// double or contradictory, and the order in which the controller executes them.
class BlockPlan {
  public:
    BlockPlan(const grammar::Dialect& dialect, lexer::Lexer& lexer, lexer::Diagnostics& diagnostics)
        : dialect_(dialect), lexer_(lexer), diagnostics_(diagnostics) {}

    /// Plans one block of words. False where an error was reported. Valid until the next call.
    bool plan(const grammar::Block& block);

    std::span<const Call> calls() const { return calls_; }
    /// Word indices of a call's operands.
    std::span<const std::uint32_t> operands(const Call& call) const {
        return std::span(operands_).subspan(call.first_operand, call.operand_count);
    }

  private:
    bool only_moves(const grammar::Block& block);
    bool collect_codes(const grammar::Block& block);
    bool add_code(const grammar::Block& block, std::uint32_t index);
    bool check_group(const grammar::Block& block, const grammar::Code& code, std::uint32_t index);
    bool choose_axis_owner(const grammar::Block& block);
    bool assign_words(const grammar::Block& block);
    bool assign(const grammar::Block& block, std::uint32_t index);
    std::int32_t owner_of(const lexer::Word& word) const;
    bool check_needs(const grammar::Block& block, const Call& call, std::uint64_t addresses);
    bool check_all_needs(const grammar::Block& block);
    void gather_operands();
    void drop_idle_one_shots(const grammar::Block& block);
    bool fail(const grammar::Block& block, std::uint32_t word, const std::string& message);

    const grammar::Dialect& dialect_;
    lexer::Lexer& lexer_;
    lexer::Diagnostics& diagnostics_;
    std::vector<Call> calls_;
    std::vector<std::uint32_t> operands_;
    std::vector<std::int32_t> owners_;  // by word: index of its call, or -1
    std::int32_t axis_owner_ = -1;
};

/// The key of an operand in the table that a library function takes: "x", "ar", "i1".
std::string_view lua_key(lexer::Address address);

}  // namespace gsim::codegen
