#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "tests/conformance/move.h"

namespace gsim::conformance {

/// Reads what `gsim-run --moves` writes: JSON Lines, docs/report.md. Axes that the machine lacks are at 0.
/// The error says which line cannot be understood.
tl::expected<std::vector<Move>, std::string> read_moves(std::istream& text);

}  // namespace gsim::conformance
