#pragma once

#include <optional>
#include <string_view>

namespace gsim::calibrate {

/// Reads a time at the beginning of a line, s: seconds, a time of day (12:34:56.789), or a date and a time
/// (2024-05-01T12:34:56.789Z, or with a blank between), in square brackets or not. The remainder stays in
/// `line`. Empty if the line has no time.
std::optional<double> consume_time_s(std::string_view& line);

}  // namespace gsim::calibrate
