#pragma once

#include <span>

#include "machine/model/machine.h"
#include "tests/accuracy/programmed_move.h"

namespace gsim::accuracy {

/// Returns the time of a program by klipper_estimator 3.7 (Annex Engineering; lib/src/planner.rs, arcs.rs),
/// in s, from its rules and the limits of a Klipper machine. It is the planner of Klipper, with dwells that
/// do not stop it. The estimator follows changes of the limits by a program (M204, SET_VELOCITY_LIMIT), which
/// are not known here. Do not use it for such programs.
double klipper_estimator_s(std::span<const ProgrammedMove> moves, const machine::Machine& machine);

}  // namespace gsim::accuracy
