#pragma once

#include <string>
#include <vector>

#include "runtime/machine/machine.h"

namespace gsim::calibrate {

/// A way of planning that a machine may be fitted with.
struct Candidate {
    std::string name;  ///< "velocity-step, straight ramps"
    machine::Machine machine;
    bool each_axis = false;  ///< Figures of each axis by themselves, where axes begin with the same.
};

/// The machine with each generic way of planning: from rest to rest, corners by a step of speed, by junction
/// deviation or rounded within a tolerance (by a constant acceleration, or by one that grows and falls), or
/// moves that overlay each other, each with straight ramps and with limited jerk. None is a model of a
/// control that somebody has looked into.
std::vector<Candidate> generic_candidates(const machine::Machine& machine, bool each_axis);

/// What a candidate may be refined by, one thing each; nothing that it has already.
std::vector<Candidate> refinements(const Candidate& candidate);

}  // namespace gsim::calibrate
