#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/fit.h"

namespace gsim::calibrate {

/// A way of planning that a machine may be fitted with.
struct Candidate {
    std::string name;  ///< "velocity-step, straight ramps"
    machine::Machine machine;
};

/// The machine with each generic way of planning: from rest to rest, corners by a step of speed, by junction
/// deviation or rounded within a tolerance, each with straight ramps and with limited jerk. None is a model
/// of a control that somebody has looked into.
std::vector<Candidate> generic_candidates(const machine::Machine& machine);

/// How well a candidate goes with the runs. Errors are without sign.
struct Score {
    std::string name;
    double fitted_percent = 0;   ///< Their mean over runs that it was fitted to.
    bool foretells = false;      ///< It was tried on runs that it was not fitted to:
    double mean_percent = 0;     ///< the mean over these
    double largest_percent = 0;  ///< and the largest.
    std::string refused = {};    ///< Why it could not be fitted; empty where it was.
};

struct Choice {
    std::vector<Score> scores;  ///< In the order of the candidates.
    std::size_t best = 0;
};

/// All candidates are fitted to all runs, and the two that come nearest are tried by cross-validation: the
/// runs are dealt to `parts` parts (at least 2), each part is foretold by a fit to the others, and the
/// candidate with the least mean error is the best one. The error: none could be fitted.
tl::expected<Choice, std::string> choose_model(std::span<const Candidate> candidates,
                                               std::span<const RecordedRun> runs, const Predictor& predictor,
                                               std::size_t parts, bool each_axis,
                                               const std::function<void(const std::string&)>& told = {});

}  // namespace gsim::calibrate
