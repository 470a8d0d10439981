#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "codegen/blocks/block_plan.h"
#include "codegen/blocks/block_values.h"
#include "grammar/syntax.h"

namespace gsim::codegen {

/// Appends the Lua of one call of a block's plan, and a blank; words whose values have been worked out before
/// (`values`) are their locals. With `further` ("`, true`"), an argument behind its words, the call stands in
/// round brackets.
void write_call(const grammar::Block& block, const BlockPlan& plan, const Call& call,
                const BlockValues& values, std::string& out, std::string_view further = {});

/// A number of a program or block without leading zeros; the digits are few, see the scanner.
std::string normal_number(std::string_view digits);

/// True for digits alone, one at least.
bool all_digits(std::string_view text);

/// An upper bound of the instructions that Lua makes of a call.
std::uint64_t weight(const Call& call);

}  // namespace gsim::codegen
