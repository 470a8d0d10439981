#pragma once

#include <optional>

#include "base/text/diagnostic.h"
#include "grammar/dialect.h"
#include "lexer/source.h"

namespace gsim::codegen {

/// Why a program looks like one of another dialect than it was read as, with what to try as its hint; nothing
/// where nothing speaks for another one. For programs that failed. It reads
/// the source from its start, at most its first 256 KiB.
std::optional<text::Diagnostic> find_dialect_hint(lexer::Source& source, const grammar::Dialect& read_as);

/// Why a program that says neither G20 nor G21 and is read in mm looks like one in inches;
/// nothing where it does not. Its numbers say so:
/// - no coordinate (X, Y, Z) is beyond 10, and three have three or four decimals; or none is beyond 40, and a
///   quarter of them has four decimals;
/// - none has more than four;
/// - there is a feed, and none is above 100.
/// What speaks in variables alone says nothing. It reads the source from its start, at most its first 256
/// KiB.
std::optional<text::Diagnostic> find_inch_signs(lexer::Source& source);

}  // namespace gsim::codegen
