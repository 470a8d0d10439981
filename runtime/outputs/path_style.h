#pragma once

#include <cstdint>

namespace gsim::simulation {

/// Style of a part of the path and, except for `out_of_range` (past a limit), of its speed over time.
enum class PathStyle : std::uint8_t { rapid, feed, jet, out_of_range };

}  // namespace gsim::simulation
