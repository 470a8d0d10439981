#pragma once

#include <cstddef>
#include <vector>

#include "cam/linking/axis_way.h"
#include "cam/linking/rapid_space.h"

namespace gsim::transit {

/// The result for the paths between cuts.
struct Transit {
    std::size_t ways = 0;     ///< From one cut, or the start, to the next cut, or the end.
    std::size_t changed = 0;  ///< Paths that were rerouted.
    /// Messages, at most one for each path: cuts that collide with bodies of the cell, and paths that were
    /// not found.
    std::vector<path::Fault> faults = {};
};

/// Reroutes the rapids of a program past the bodies of a cell. If a rapid would come nearer to something than
/// the cell's clearance, rapids around it replace it. Checks the cuts, too. Each path of the program is used
/// once. `start` is the machine position before the program, in machine coordinates. The error is an error of
/// the path itself: an axis that would leave its range.
tl::expected<Transit, path::Fault> clear_ways(path::Program& program, const RapidSpace& space,
                                              const AxisValues& start);

/// Returns true if a program specifies a tool orientation anywhere.
bool names_orientations(const path::Program& program);

}  // namespace gsim::transit
