#pragma once

#include <cstdint>

#include "lexer/alias.h"
#include "lexer/source.h"
#include "lexer/style.h"

namespace gsim::codegen {

/// How many lines before the first % of a source are the leader of a tape, which controls pass over: where
/// none of them is a block and something stands behind the %. Reads the source from its start, and rewinds
/// it.
std::uint32_t leader_lines(lexer::Source& source, const lexer::Aliases& aliases, lexer::Style style);

}  // namespace gsim::codegen
