#pragma once

#include <tl/expected.hpp>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/piece.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// The piece of a move with the limits that follow from the joints'; of length 0 where the move goes nowhere.
/// RRS_ZERO_SPEED without a speed, RRS_INVALID_PARAMETER where
/// positions or the time are no numbers of this world.
tl::expected<Piece, PlanError> piece_of(const PlannerSetup& setup, const Axes& axes, const PathMove& move,
                                        const Planning& planning);

/// Whether piece_of() surely makes a piece of a move, one of X, Y and Z alone; told of feed moves along lines
/// by the lowest limits of these axes, for moves that become part of a longer line.
bool surely_makes_piece(const PlannerSetup& setup, const PathMove& move);

}  // namespace gsim::motion::linuxcnc
