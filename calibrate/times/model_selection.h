#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/times/fit.h"
#include "calibrate/times/models.h"

namespace gsim::calibrate {

/// Agreement of a candidate with the runs. Errors are without sign.
struct Score {
    std::string name;
    double fitted_percent = 0;    ///< Their mean over runs that it was fitted to.
    bool is_predicted = false;    ///< It was tried on runs that it was not fitted to:
    double mean_percent = 0;      ///< the mean over these
    double largest_percent = 0;   ///< and the largest.
    std::string error_text = {};  ///< Reason why the fit failed; empty if it succeeded.
};

struct ModelSelection {
    std::vector<Score> scores;  ///< In the order in which they were tried.
    std::size_t best = 0;       ///< Index in these.
    Candidate candidate;        ///< It, with the figures that were fitted to all runs.
};

/// Fits all candidates to all runs, and tries the three nearest ones by cross-validation. The runs are
/// distributed to `parts` parts (at least 2), and each part is predicted by a fit to the others. The best
/// predictor is refined (refinements()), one step at a time, as long as a step reduces the mean error; so is
/// the second best if the first is more than 0.3 % off. A more complex candidate replaces a simpler one only
/// if it predicts better. It must be better by a tenth (and 0.1 %) or by more than the standard error of the
/// difference, twice that for a refinement. The order of the candidates is from simple to less simple. The
/// error: none could be fitted.
Result<ModelSelection> select_model(std::span<const Candidate> candidates, std::span<const RecordedRun> runs,
                                    const Predictor& predictor, std::size_t parts,
                                    const std::function<void(const std::string&)>& on_message = {});

}  // namespace gsim::calibrate
