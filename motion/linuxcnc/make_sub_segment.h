#pragma once

#include <tl/expected.hpp>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/sub_segment.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// Returns the sub-segment of a move with the limits that follow from those of the joints; its length is 0 if
/// the move has no motion. Errors: RRS_ZERO_SPEED without a speed, RRS_INVALID_PARAMETER if positions or the
/// time are no usable numbers.
tl::expected<SubSegment, PlanError> make_sub_segment(const PlannerSetup& setup, const Axes& axes,
                                                     const PathMove& move, const PlanningRules& planning);

/// True if make_sub_segment() certainly makes a sub-segment of a move of only X, Y and Z. Checks feed moves
/// along lines by the lowest limits of these axes, for moves that become part of a longer line.
bool certainly_moves(const PlannerSetup& setup, const PathMove& move);

}  // namespace gsim::motion::linuxcnc
