#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/conformance/move.h"

namespace gsim::conformance {

/// A move that the reference printed, in machine coordinates, and how far the printed digits leave it open.
struct ExpectedMove {
    Move move;               ///< `line` is that of the canonical output. A spline has no end point there.
    AxisValues tolerance{};  ///< mm and deg
    AxisValues stop{};       ///< Position of the reference afterwards: `move.to`, except for a probe.
    double feed_tolerance = 0;
    double feed_unit_mm = 1;  ///< mm in the unit of `feed_per_min`, which is 1 deg if only rotary axes move.
};

/// Reads canonical output as LinuxCNC's stand-alone interpreter prints it. It applies units, work offsets,
/// the offset of G92, the rotation about Z and the tool's offset. The moves are therefore in mm, deg and
/// machine coordinates. The error names the line that cannot be parsed.
Result<std::vector<ExpectedMove>> read_canon(std::istream& text);

}  // namespace gsim::conformance
