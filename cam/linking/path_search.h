#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "toolpath/rotary/machine_space.h"

namespace gsim::linking {

using path::AxisValues;

/// Paths from node to node, each straight in the values of all axes: without their first node.
using AxisPath = std::vector<AxisValues>;

/// The space in which paths are searched.
struct SearchSpace {
    AxisValues low, high;   ///< Axis limits, mm or deg; finite.
    AxisValues s_per_unit;  ///< Time of an axis for a mm or deg, s; 0: it does not count.
    /// Returns true if the machine may move straight from one node to the other.
    std::function<bool(const AxisValues& from, const AxisValues& to)> is_clear;
    /// Returns the time for that.
    std::function<double(const AxisValues& from, const AxisValues& to)> seconds;
};

/// Returns the time for a path that begins at `from`.
double path_duration_s(const SearchSpace& space, const AxisValues& from, const AxisPath& path);

/// Returns a path between two clear nodes. Random trees grow towards each other from both ends (RRT-Connect:
/// J. Kuffner and S. LaValle, 2000). The path is shortened; the fastest of a few is returned, and the same
/// one each time. Returns nothing if three searches fail, after `max_queries` calls of is_clear() each.
std::optional<AxisPath> search_path(const SearchSpace& space, const AxisValues& from, const AxisValues& to,
                                    int max_queries);

/// Returns the path without unnecessary nodes, and shortened if that takes less time.
AxisPath shortcut(const SearchSpace& space, const AxisValues& from, AxisPath path);

}  // namespace gsim::linking
