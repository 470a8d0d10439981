#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/times/fit.h"
#include "calibrate/times/models.h"

namespace gsim::calibrate {

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
    std::vector<Score> scores;  ///< In the order in which they were tried.
    std::size_t best = 0;       ///< Of these.
    Candidate candidate;        ///< It, with the figures that were fitted to all runs.
};

/// All candidates are fitted to all runs, and the three that come nearest are tried by cross-validation: the
/// runs are dealt to `parts` parts (at least 2), and each part is foretold by a fit to the others. The one
/// that foretells best is refined (refinements()), one thing at a time, as long as one lessens the mean
/// error; so is the second best where the first is more than 0.3 % off. A candidate with more to it takes the
/// place of a simpler one only where it foretells better, by a tenth (and 0.1 %) or by more than the standard
/// error of the difference, twice that of a refinement; the order of the candidates is that from simple to
/// less simple. The error: none could be fitted.
tl::expected<Choice, std::string> choose_model(std::span<const Candidate> candidates,
                                               std::span<const RecordedRun> runs, const Predictor& predictor,
                                               std::size_t parts,
                                               const std::function<void(const std::string&)>& told = {});

}  // namespace gsim::calibrate
