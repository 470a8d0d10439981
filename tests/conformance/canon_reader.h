#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "tests/conformance/move.h"

namespace gsim::conformance {

/// A move that the reference printed, in machine coordinates, and how far the printed digits leave it open.
struct ExpectedMove {
    Move move;               ///< `line` is that of the canonical output. A spline has no end point there.
    AxisValues tolerance{};  ///< mm and deg
    AxisValues stop{};       ///< Where the reference stands afterwards: `move.to`, but for a probe.
    double feed_tolerance = 0;
    double feed_unit_mm =
        1;  ///< mm in the unit of `feed_per_min`, which is 1 deg where only rotary axes move.
};

/// Reads canonical output as LinuxCNC's stand-alone interpreter prints it: units, work offsets, the offset of
/// G92, the rotation about Z and the tool's offset are applied, so that the moves come in mm, deg and machine
/// coordinates. The error says which line cannot be understood.
tl::expected<std::vector<ExpectedMove>, std::string> read_canon(std::istream& text);

}  // namespace gsim::conformance
