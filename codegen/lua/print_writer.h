#pragma once

#include <string>

#include "base/error.h"
#include "grammar/syntax.h"

namespace gsim::codegen {

/// Appends the Lua of a block of BlockKind::print. In the text of DPRNT, `*` is a blank and #5[53] the value
/// of #5 with five digits before and three after the point.
Result<void> write_print(const grammar::Block& block, std::string& out);

}  // namespace gsim::codegen
