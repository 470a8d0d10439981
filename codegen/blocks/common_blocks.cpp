// Common blocks of a tool path, planned without the general code. Blocks that do not fit are passed to it,
// and errors are reported there.

#include <span>
#include <vector>

#include "codegen/blocks/block_plan.h"

namespace gsim::codegen {

using grammar::AxisUse;
using grammar::Block;
using grammar::Code;
using lexer::Address;
using lexer::Role;
using lexer::Word;

namespace {

/// Set that detects repeated addresses; occasionally also two that are different.
class SeenAddresses {
  public:
    bool is_repeated(Address address) {
        const std::uint64_t bit = std::uint64_t{1} << (address & 63U);
        const bool known = (addresses_ & bit) != 0;
        addresses_ |= bit;
        return known;
    }

  private:
    std::uint64_t addresses_ = 0;
};

bool is_arc(const Code& code) {
    return code.code_x10 == 20 || code.code_x10 == 30;
}

}  // namespace

void BlockPlan::add_single_call(const Call& call, std::uint32_t first_operand, std::size_t words) {
    for (auto i = first_operand; i < words; ++i) operands_.push_back(i);
    calls_.push_back(call);
    calls_.back().operand_count = static_cast<std::uint32_t>(operands_.size());
}

/// Returns true for axis words alone.
bool BlockPlan::plan_axis_words(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    SeenAddresses seen;
    for (const Word& word : words) {
        if (!is_axis(word) || seen.is_repeated(word.address)) return false;
    }
    if (!words.empty()) add_single_call({}, 0, words.size());
    return true;
}

/// Returns true for a motion code with words that it accepts.
bool BlockPlan::plan_single_motion(const Block& block) {
    const std::vector<Word>& words = block.text->words;
    const Word& first = words.front();
    if (first.address != 'G' || first.expression >= 0) return false;
    const Code* code = dialect_.find('G', first.code_x10);
    if (code == nullptr || code->group != grammar::Group::motion || code->axes != AxisUse::motion ||
        code->support != grammar::Support::full) {
        return false;
    }
    SeenAddresses seen;
    bool has_arc_words = false;
    for (const Word& word : std::span(words).subspan(1)) {
        const bool is_allowed = is_axis(word) || (word.role != Role::time && word.role != Role::program &&
                                                  accepts(*code, word.address));
        if (!is_allowed || seen.is_repeated(word.address)) return false;
        has_arc_words |= is_arc_word(word.address);
    }
    if (is_arc(*code) && !has_arc_words) return false;
    add_single_call({.kind = Call::Kind::code, .phase = code->phase, .code = code}, 1, words.size());
    return true;
}

}  // namespace gsim::codegen
