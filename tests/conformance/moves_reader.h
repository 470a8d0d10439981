#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/conformance/move.h"

namespace gsim::conformance {

/// Reads what `gsim-run --moves` writes: JSON Lines, docs/report.md. Axes that the machine lacks are at 0.
/// The error says which line cannot be understood.
Result<std::vector<Move>> read_moves(std::istream& text);

}  // namespace gsim::conformance
