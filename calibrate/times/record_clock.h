#pragma once

#include <optional>
#include <string_view>

namespace gsim::calibrate {

/// A time at the beginning of a line, s: seconds, a time of day (12:34:56.789), or a date and a time
/// (2024-05-01T12:34:56.789Z, or with a blank between), in square brackets or not. What stands behind it is
/// left in `line`. Nothing where there is none.
std::optional<double> take_time_s(std::string_view& line);

}  // namespace gsim::calibrate
