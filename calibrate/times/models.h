#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/times/parameter.h"
#include "machine/model/machine.h"

namespace gsim::calibrate {

/// Planning method for the fit of a machine.
struct Candidate {
    std::string name;  ///< "velocity-step, straight ramps"
    machine::Machine machine;
    FreeParameters open = {};
};

/// Returns the machine with each generic planning method: from standstill to standstill, corners by a step of
/// speed, by junction deviation or rounded within a tolerance, or overlaid moves. Rounding has a constant
/// acceleration, or one that rises and falls. Each method comes with straight ramps and with limited jerk. No
/// method is a model of an analysed controller.
std::vector<Candidate> generic_candidates(const machine::Machine& machine, const FreeParameters& open);

/// Returns possible refinements of a candidate, one change each, except those it already has. `words`: keys
/// of [times] for which programs have words.
std::vector<Candidate> refinements(const Candidate& candidate, std::span<const std::string> words);

}  // namespace gsim::calibrate
