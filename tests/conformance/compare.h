#pragma once

#include <optional>
#include <span>
#include <string>

#include "tests/conformance/canon_reader.h"

namespace gsim::conformance {

/// First position at which two runs differ.
struct Difference {
    std::string what;      ///< Such as "end point: X is 1.00000, 1.50000 is expected".
    std::string expected;  ///< The move of the reference with its line.
    std::string found;     ///< The move of gsim with its line.
};

struct Verdict {
    std::size_t agreed = 0;  ///< Moves that agree before the first difference.
    std::optional<Difference> difference;
};

/// Compares a run with the reference: kind, order, end point, arc centre, sense, turns, plane, feed and
/// seconds of dwell, each within the printed digits. Moves without length are left out on both sides, as far
/// as the printed digits show. A spline of the reference, which is printed without its points, represents one
/// or more spline moves of one line. At the end of a probe, the reference is a little before its target and
/// gsim on it; both are right until an axis is moved again.
Verdict compare(std::span<const ExpectedMove> expected, std::span<const Move> found);

}  // namespace gsim::conformance
