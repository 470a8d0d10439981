#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "toolpath/rotary/machine_space.h"

namespace gsim::transit {

using path::AxisValues;

/// Ways that lead from node to node, each straight in the values of all axes: without their first node.
using Way = std::vector<AxisValues>;

/// Where ways are searched for.
struct WaySpace {
    AxisValues low, high;  ///< Of the axes, mm or deg; finite.
    AxisValues pace;       ///< How long an axis takes for a mm or deg, s; 0: it need not be counted.
    /// Whether the machine may go straight from one node to the other.
    std::function<bool(const AxisValues& from, const AxisValues& to)> is_clear;
    /// How long that takes.
    std::function<double(const AxisValues& from, const AxisValues& to)> seconds;
};

/// How long a way takes that begins at `from`.
double seconds_of(const WaySpace& space, const AxisValues& from, const Way& way);

/// A way between two nodes that both are clear, by random trees that grow towards each other from both ends
/// (RRT-Connect: J. Kuffner and S. LaValle, 2000), shortened; the quickest of a few, and the same one each
/// time. Nothing where three searches end in vain, after `most_questions` to is_clear() each.
std::optional<Way> search_way(const WaySpace& space, const AxisValues& from, const AxisValues& to,
                              int most_questions);

/// The way without the nodes that need not be, and cut short where that takes less time.
Way shortened(const WaySpace& space, const AxisValues& from, Way way);

}  // namespace gsim::transit
