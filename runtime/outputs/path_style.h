#pragma once

#include <cstdint>

namespace gsim::simulation {

/// How a piece of path is drawn, and but for `beyond` (past a limit) its speed over time.
enum class PathStyle : std::uint8_t { rapid, feed, jet, beyond };

}  // namespace gsim::simulation
