#pragma once

#include <span>

#include "machine/model/machine.h"
#include "tests/accuracy/programmed_move.h"

namespace gsim::accuracy {

/// What klipper_estimator 3.7 (Annex Engineering; lib/src/planner.rs, arcs.rs) says of a program, s, by its
/// rules and the limits of a machine of Klipper's: the planner of Klipper, with dwells that do not stop it.
/// The estimator follows what a program changes of the limits (M204, SET_VELOCITY_LIMIT), which is not known
/// here: it is not to be asked of such programs.
double klipper_estimator_s(std::span<const ProgrammedMove> moves, const machine::Machine& machine);

}  // namespace gsim::accuracy
