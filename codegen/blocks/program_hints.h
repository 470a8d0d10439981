#pragma once

#include <optional>

#include "base/text/diagnostic.h"
#include "grammar/dialect.h"
#include "lexer/source.h"

namespace gsim::codegen {

/// Returns the reason why a program looks like one of another dialect than the one it was read as, with the
/// suggested dialect as its hint. Returns no value if no feature indicates another one. For programs that
/// failed. It reads the source from its start, at most its first 256 KiB.
std::optional<text::Diagnostic> find_dialect_hint(lexer::Source& source,
                                                  const grammar::Dialect& current_dialect);

/// Returns the reason why a program that has neither G20 nor G21 and is read in mm looks like one in inches;
/// no value if it does not. Its numbers are the evidence:
/// - no coordinate (X, Y, Z) is beyond 10, and three have three or four decimals; or none is beyond 40, and a
///   quarter of them has four decimals;
/// - no coordinate has more than four;
/// - it has a feed, and no feed is above 100.
/// A program with only variables gives no evidence. It reads the source from its start, at most its first 256
/// KiB.
std::optional<text::Diagnostic> find_inch_hint(lexer::Source& source);

}  // namespace gsim::codegen
