#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cam/linking/rapid_planner.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::linking {

/// A section of the motion that is straight in all axes.
struct AxisStep {
    path::TargetId where;   ///< The target at its end, or the next one on the path.
    path::AxisValues axes;  ///< End point in machine coordinates, mm or deg.
    bool rapid = false;
    bool process_on = false;
};

/// Returns the motion of the axes through a complete program, with sub-paths inserted and arcs as chords, as
/// path2gcode writes it. The error names target and axis: out of its range, or not reachable.
tl::expected<std::vector<AxisStep>, path::TargetError> axis_steps(const path::Program& program,
                                                                  const path::MachineSpace& machine,
                                                                  const Origin& origin);

}  // namespace gsim::linking
