#pragma once

#include <cstddef>
#include <vector>

#include "cam/linking/axis_way.h"
#include "cam/linking/rapid_space.h"

namespace gsim::transit {

/// What became of the ways between cuts.
struct Transit {
    std::size_t ways = 0;     ///< From one cut, or the start, to the next cut, or the end.
    std::size_t changed = 0;  ///< Of these: they lead round something now.
    /// Cuts that bodies of the cell are in the way of, and ways that were not found: sentences, one for each
    /// path at most.
    std::vector<path::Fault> faults = {};
};

/// Leads the rapids of a program past the bodies of a cell: where one would come nearer to something than
/// the cell's clearance, rapids round it take its place. Looks at the cuts, too. Each path of the program
/// is used once. `start` is where the machine stands before, machine coordinates. The error is a fault of the
/// path itself: an axis that would leave its range.
tl::expected<Transit, path::Fault> clear_ways(path::Program& program, const RapidSpace& space,
                                              const AxisValues& start);

/// Whether a program says anywhere how the tool stands.
bool names_orientations(const path::Program& program);

}  // namespace gsim::transit
