#pragma once

#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/geometry/geometry_fit.h"

namespace gsim::calibrate {

/// A compensation table of LinuxCNC ([JOINT_n] COMP_FILE with COMP_FILE_TYPE = 0): lines of a nominal place
/// and where the axis really is there, going forward and back, which are the same here.
struct CompensationTable {
    char letter = 'X';
    std::string text;
};

/// A table for each axis whose scale was found, over its range, or where that has no ends, over `tips`.
std::vector<CompensationTable> compensation_tables(const GeometryFit& fit, std::span<const MeasuredTip> tips);

/// A line of G-code (G10 L2 P1) that sets the work offset so that a program's zero is the work frame's
/// origin, with rotary axes at the zeros that were found. The error: the machine has no three slides that do
/// that.
tl::expected<std::string, std::string> work_offset_line(const machine::Machine& nominal,
                                                        const GeometryFit& fit);

}  // namespace gsim::calibrate
