#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/times/parameter.h"
#include "machine/model/machine.h"

namespace gsim::calibrate {

/// A way of planning that a machine may be fitted with.
struct Candidate {
    std::string name;  ///< "velocity-step, straight ramps"
    machine::Machine machine;
    OpenFigures open = {};
};

/// The machine with each generic way of planning: from rest to rest, corners by a step of speed, by junction
/// deviation or rounded within a tolerance (by a constant acceleration, or by one that grows and falls), or
/// moves that overlay each other, each with straight ramps and with limited jerk. None is a model of a
/// control that somebody has looked into.
std::vector<Candidate> generic_candidates(const machine::Machine& machine, const OpenFigures& open);

/// What a candidate may be refined by, one thing each; nothing that it has already. `words`: keys of [times]
/// that programs have words for.
std::vector<Candidate> refinements(const Candidate& candidate, std::span<const std::string> words);

}  // namespace gsim::calibrate
