#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::calibrate {

/// Set and actual positions of an axis over time, mm or deg.
struct AxisRecord {
    char letter = 'X';
    std::vector<double> t_s;  ///< Rising.
    std::vector<double> set_points;
    std::vector<double> positions;
};

/// Format of a recording that is columns of numbers without names.
struct ServoFormat {
    double period_s = 0;  ///< Between samples; 0: not known.
    std::string columns =
        "Xx";  ///< A letter each: capital ones are set points, small ones positions; '-' is skipped.
};

/// Reads a recording of set points and positions of axes, in one of these forms, which it detects:
/// - CSV with a first line that names the columns: t_s, and for each axis its set point (x_mm, b_deg)
///   with its position (x_at_mm) or its following error (x_error_mm), as gsim-run --trajectory
///   --following writes it;
/// - output of LinuxCNC's halsampler: numbers in columns, with or without its -t.
/// Samples with a time that does not rise are left out. The error names the line and what it lacks.
Result<std::vector<AxisRecord>> read_servo_record(std::string_view text, const ServoFormat& columns_format);

}  // namespace gsim::calibrate
