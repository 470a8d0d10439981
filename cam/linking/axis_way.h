#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cam/linking/rapid_space.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::transit {

/// A stretch that is straight in all axes.
struct AxisStep {
    path::TargetId where;   ///< The target that it leads to, or on the way to.
    path::AxisValues axes;  ///< Where it ends, in machine coordinates, mm or deg.
    bool rapid = false;
    bool jet_on = false;
};

/// How the axes go through a whole program, sub-paths where they are used and arcs as chords, as
/// path2gcode writes it. The error names target and axis: out of its range, or no way there.
tl::expected<std::vector<AxisStep>, path::Fault> axis_way(const path::Program& program,
                                                          const path::MachineSpace& machine,
                                                          const Origin& origin);

}  // namespace gsim::transit
