#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::calibrate {

/// An axis over time: where it should be and where it was, mm or deg.
struct AxisRecord {
    char letter = 'X';
    std::vector<double> t_s;  ///< Rising.
    std::vector<double> set_points;
    std::vector<double> places;
};

/// How a recording is to be understood that is columns of numbers without names.
struct ServoForm {
    double period_s = 0;  ///< Between samples; 0: not known.
    std::string columns =
        "Xx";  ///< A letter each: capital ones are set points, small ones places; '-' is left out.
};

/// A recording of set points and places of axes, in one of these forms, which it shows by itself:
/// - CSV under a line that names the columns: t_s, and of each axis its set point (x_mm, b_deg) with its
/// place
///   (x_at_mm) or its following error (x_error_mm), as gsim-run --trajectory --following writes it;
/// - what LinuxCNC's halsampler prints: numbers in columns, with or without its -t.
/// Samples whose time does not rise are left out. The error says which line lacks what.
tl::expected<std::vector<AxisRecord>, std::string> read_servo_record(std::string_view text,
                                                                     const ServoForm& form);

}  // namespace gsim::calibrate
