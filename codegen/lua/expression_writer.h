#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grammar/syntax.h"

namespace gsim::codegen {

/// Appends the Lua of the expression at node `index`: numbers as floats, #5 as v[5], operators in Lua's
/// spelling, brackets if the order of evaluation needs them. A comparison instead of a number becomes 1 or 0.
void write_number(const grammar::Block& block, std::int32_t index, std::string& out);

/// Appends the Lua of a condition. A number instead of a truth value counts as true unless it is 0.
void write_condition(const grammar::Block& block, std::int32_t index, std::string& out);

/// Returns the column of an expression of the block with deeper nesting in Lua than Lua reads. Returns no
/// value if all are shallow enough, as in any program that people write. `used_levels`: levels of the
/// structures around it.
std::optional<std::uint32_t> nested_too_deep(const grammar::Block& block, int used_levels);

}  // namespace gsim::codegen
