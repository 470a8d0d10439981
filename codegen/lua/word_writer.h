#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "codegen/blocks/block_plan.h"
#include "codegen/blocks/block_values.h"
#include "grammar/syntax.h"

namespace gsim::codegen {

/// Appends the Lua of one call of a block's plan, and a blank; words that have been evaluated before
/// (`values`) are their locals. With `suffix` ("`, true`"), a trailing argument, the call is in round
/// brackets.
void write_call(const grammar::Block& block, const BlockPlan& plan, const Call& call,
                const BlockValues& values, std::string& out, std::string_view suffix = {});

/// Returns a number of a program or block without leading zeros; the scanner limits the count of digits.
std::string normalized_number(std::string_view digits);

/// Returns true for digits alone, at minimum one.
bool all_digits(std::string_view text);

/// Returns an upper bound of the instructions that Lua makes of a call.
std::uint64_t weight(const Call& call);

}  // namespace gsim::codegen
