#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/geometry/geometry_fit.h"

namespace gsim::calibrate {

/// Compensation table of LinuxCNC ([JOINT_n] COMP_FILE with COMP_FILE_TYPE = 0). Each line has a nominal
/// position and the real position of the axis there, forward and back, which are equal here.
struct CompensationTable {
    char letter = 'X';
    std::string text;
};

/// Returns a table for each axis with a fitted scale, over its range, or if that is unbounded, over `tcps`.
std::vector<CompensationTable> compensation_tables(const GeometryFit& fit, std::span<const MeasuredTcp> tcps);

/// Returns a line of G-code (G10 L2 P1) that sets the work offset. It makes a program's zero the work frame's
/// origin, with rotary axes at the fitted zeros. The error: the machine has no three slides that can do that.
Result<std::string> work_offset_line(const machine::Machine& nominal, const GeometryFit& fit);

}  // namespace gsim::calibrate
