#pragma once

#include <cstddef>
#include <vector>

#include "cam/linking/axis_steps.h"
#include "cam/linking/rapid_planner.h"

namespace gsim::linking {

/// The result for the paths between cuts.
struct LinkingResult {
    std::size_t linking_paths = 0;  ///< From one cut, or the start, to the next cut, or the end.
    std::size_t changed = 0;        ///< Paths that were rerouted.
    /// Messages, at most one for each path: cuts that collide with bodies of the cell, and paths that were
    /// not found.
    std::vector<path::TargetError> errors = {};
};

/// Reroutes the rapids of a program past the bodies of a cell. If a rapid would come nearer to something than
/// the cell's clearance, rapids around it replace it. Checks the cuts, too. Each path of the program is used
/// once. `start` is the machine position before the program, in machine coordinates. The error is an error of
/// the path itself: an axis that would leave its range.
tl::expected<LinkingResult, path::TargetError> avoid_collisions(path::Program& program,
                                                                const RapidPlanner& space,
                                                                const AxisValues& start);

/// Returns true if a program specifies a tool orientation anywhere.
bool has_orientations(const path::Program& program);

}  // namespace gsim::linking
