#pragma once

#include <cstdint>

#include "lexer/alias.h"
#include "lexer/source.h"
#include "lexer/text_rules.h"

namespace gsim::codegen {

/// Returns the number of lines before the first % of a source that are the leader of a tape, which
/// controllers skip. It is a leader if no line of it is a block and text follows the %. Reads the source from
/// its start, and rewinds it.
std::uint32_t leader_lines(lexer::Source& source, const lexer::Aliases& aliases,
                           const lexer::TextRules& rules);

}  // namespace gsim::codegen
