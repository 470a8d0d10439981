#include "calibrate/times/model_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

constexpr std::size_t kCrossValidated = 3;       // of all candidates, by cross-validation
constexpr double kNearFactor = 1.25;             // of the best fit's error: what comes so near is tried, too
constexpr std::size_t kMaxRefinements = 4;       // max iterations
constexpr double kMaxFitRatio = 0.95;            // of the fit's error: what lessens it by less is not tried
constexpr int kMaxSelectionSteps = 12;           // of a fit; what is chosen is fitted to its end
constexpr int kPartSteps = 3;                    // from what was fitted to all runs
constexpr double kModelStandardErrors = 1;       // standard errors
constexpr double kRefinementStandardErrors = 2;  // of which there are many, so that one may seem to help
constexpr double kMinGain_percent = 0.1;         // required in addition
constexpr double kMinRelativeGain = 0.1;         // of the mean error
constexpr double kGoodEnough_percent = 0.3;      // in the mean: then the second best is not refined
constexpr double kNearEnough_percent = 0.02;     // in the mean: less is not looked for

/// Returns the indices of the runs in one of several parts, or of those outside it.
std::vector<std::size_t> part_indices(std::size_t runs, std::size_t parts, std::size_t part,
                                      bool is_in_part) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < runs; ++i) {
        if ((i % parts == part) == is_in_part) indices.push_back(i);
    }
    return indices;
}

double average(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Candidate that has been tried.
struct EvaluatedCandidate {
    Candidate candidate;  ///< As fitted to all runs.
    std::size_t score = 0;
    std::vector<double> errors_percent;  ///< For each run, predicted by a fit to others.
};

/// Trial of candidates on runs, with their results.
class Trial {
  public:
    Trial(std::span<const RecordedRun> runs, const Predictor& predictor, std::size_t parts,
          const std::function<void(const std::string&)>& on_message)
        : runs_(runs), predictor_(predictor), parts_(parts), on_message_(on_message) {}

    /// Fits a candidate to all runs; empty if that is impossible.
    std::optional<EvaluatedCandidate> fit(const Candidate& candidate) {
        scores_.push_back({candidate.name});
        Score& score = scores_.back();
        const auto fit =
            fit_times(candidate.machine, runs_, predictor_, {candidate.open, kMaxSelectionSteps});
        if (fit) {
            for (std::size_t i = 0; i < runs_.size(); ++i)
                score.fitted_percent +=
                    std::abs(runs_[i].error_percent(fit->times_s[i])) / static_cast<double>(runs_.size());
        } else {
            score.error_text = fit.error().message;
        }
        notify(score);
        if (!fit) return std::nullopt;
        return EvaluatedCandidate{{candidate.name, fit->machine, candidate.open}, scores_.size() - 1, {}};
    }

    /// Returns true if all parts could be predicted.
    bool cross_validate(EvaluatedCandidate& evaluated) {
        Score& score = scores_[evaluated.score];
        evaluated.errors_percent.assign(runs_.size(), 0);
        for (std::size_t part = 0; part < parts_; ++part) {
            if (const auto done = predict(evaluated, part); !done) {
                score.error_text = done.error().message;
                notify(score);
                return false;
            }
        }
        score.is_predicted = true;
        score.mean_percent = average(evaluated.errors_percent);
        score.largest_percent =
            *std::max_element(evaluated.errors_percent.begin(), evaluated.errors_percent.end());
        notify(score);
        return true;
    }

    double fitted_percent(const EvaluatedCandidate& evaluated) const {
        return scores_[evaluated.score].fitted_percent;
    }
    /// Returns keys of [times].
    std::vector<std::string> words() const { return predictor_.words(); }
    std::vector<Score> release_scores() { return std::move(scores_); }
    const std::vector<Score>& scores() const { return scores_; }

  private:
    Result<void> predict(EvaluatedCandidate& evaluated, std::size_t part) const {
        const auto others = part_indices(runs_.size(), parts_, part, false);
        const auto indices = part_indices(runs_.size(), parts_, part, true);
        const auto fit = fit_times(evaluated.candidate.machine, select_runs(runs_, others),
                                   predictor_.part(others), {evaluated.candidate.open, kPartSteps});
        if (!fit) return tl::unexpected(fit.error());
        const auto times = predictor_.part(indices).times_s(fit->machine);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const RecordedRun& run = runs_[indices[i]];
            if (!times[i]) return Unexpected(fmt::format("{}: {}", run.program, times[i].error().message));
            evaluated.errors_percent[indices[i]] = std::abs(run.error_percent(*times[i]));
        }
        return {};
    }

    void notify(const Score& score) const {
        if (!on_message_) return;
        if (!score.error_text.empty())
            return on_message_(fmt::format("{}: {}", score.name, score.error_text));
        if (!score.is_predicted)
            return on_message_(
                fmt::format("{}: fitted with a mean error of {:.2f} %", score.name, score.fitted_percent));
        on_message_(fmt::format("{}: predicts with a mean error of {:.2f} %, max error {:.2f} %", score.name,
                                score.mean_percent, score.largest_percent));
    }

    std::span<const RecordedRun> runs_;
    const Predictor& predictor_;
    std::size_t parts_;
    const std::function<void(const std::string&)>& on_message_;
    std::vector<Score> scores_;
};

/// Returns true if `other` predicts better: by a tenth, or by so many standard errors of the differences.
bool is_better(const EvaluatedCandidate& other, const EvaluatedCandidate& than, double standard_errors) {
    std::vector<double> error_gains;
    for (std::size_t i = 0; i < other.errors_percent.size(); ++i)
        error_gains.push_back(than.errors_percent[i] - other.errors_percent[i]);
    const double mean = average(error_gains);
    if (mean > kMinRelativeGain * average(than.errors_percent) && mean > kMinGain_percent) return true;
    double squares = 0;
    for (const double error_gain : error_gains) squares += (error_gain - mean) * (error_gain - mean);
    const auto count = static_cast<double>(error_gains.size());
    return mean > standard_errors * std::sqrt(squares / (count * (count - 1)));
}

/// Sorts by the distance to the runs, the smallest first.
void sort_by_fit(std::vector<EvaluatedCandidate>& evaluated, const Trial& trial) {
    std::stable_sort(evaluated.begin(), evaluated.end(),
                     [&](const EvaluatedCandidate& a, const EvaluatedCandidate& b) {
                         return trial.fitted_percent(a) < trial.fitted_percent(b);
                     });
}

/// Returns the candidates that could be cross-validated: the preferred one first, then the others by the
/// quality of their predictions.
std::vector<EvaluatedCandidate> evaluate_candidates(std::span<const Candidate> candidates, Trial& trial) {
    std::vector<EvaluatedCandidate> fitted_candidates;
    for (const Candidate& candidate : candidates) {
        if (auto evaluated = trial.fit(candidate)) fitted_candidates.push_back(*std::move(evaluated));
    }
    sort_by_fit(fitted_candidates, trial);
    const auto is_near = [&](std::size_t index) {
        return trial.fitted_percent(fitted_candidates[index]) <
               kNearFactor * trial.fitted_percent(fitted_candidates.front());
    };
    std::size_t count = std::min(fitted_candidates.size(), kCrossValidated);
    while (count < fitted_candidates.size() && is_near(count)) ++count;
    fitted_candidates.resize(count);
    std::erase_if(fitted_candidates, [&](EvaluatedCandidate& each) { return !trial.cross_validate(each); });
    std::sort(fitted_candidates.begin(), fitted_candidates.end(),
              [](const EvaluatedCandidate& a, const EvaluatedCandidate& b) { return a.score < b.score; });
    std::size_t best = 0;
    for (std::size_t i = 1; i < fitted_candidates.size(); ++i) {
        if (is_better(fitted_candidates[i], fitted_candidates[best], kModelStandardErrors)) best = i;
    }
    if (fitted_candidates.empty()) return fitted_candidates;
    std::rotate(fitted_candidates.begin(), fitted_candidates.begin() + static_cast<std::ptrdiff_t>(best),
                fitted_candidates.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    std::stable_sort(fitted_candidates.begin() + 1, fitted_candidates.end(),
                     [](const EvaluatedCandidate& a, const EvaluatedCandidate& b) {
                         return average(a.errors_percent) < average(b.errors_percent);
                     });
    return fitted_candidates;
}

/// Returns the model with the one addition that makes it predict better; empty if none does.
std::optional<EvaluatedCandidate> refine_once(const EvaluatedCandidate& evaluated, Trial& trial) {
    std::vector<EvaluatedCandidate> fitted_candidates;
    const double threshold_percent = kMaxFitRatio * trial.fitted_percent(evaluated);
    for (const Candidate& candidate : refinements(evaluated.candidate, trial.words())) {
        auto found = trial.fit(candidate);
        if (found && trial.fitted_percent(*found) < threshold_percent)
            fitted_candidates.push_back(*std::move(found));
    }
    sort_by_fit(fitted_candidates, trial);
    for (EvaluatedCandidate& found : fitted_candidates) {
        if (trial.cross_validate(found) && is_better(found, evaluated, kRefinementStandardErrors))
            return std::move(found);
    }
    return std::nullopt;
}

/// Adds refinements as long as they make it predict better.
EvaluatedCandidate refine_repeatedly(EvaluatedCandidate evaluated, Trial& trial) {
    for (std::size_t i = 0; i < kMaxRefinements && trial.fitted_percent(evaluated) > kNearEnough_percent;
         ++i) {
        auto better = refine_once(evaluated, trial);
        if (!better) break;
        evaluated = *std::move(better);
    }
    return evaluated;
}

}  // namespace

Result<ModelSelection> select_model(std::span<const Candidate> candidates, std::span<const RecordedRun> runs,
                                    const Predictor& predictor, std::size_t parts,
                                    const std::function<void(const std::string&)>& on_message) {
    Trial trial(runs, predictor, parts, on_message);
    std::vector<EvaluatedCandidate> evaluated = evaluate_candidates(candidates, trial);
    if (evaluated.empty())
        return tl::unexpected(candidates.empty() ? std::string("there is no model to choose from")
                                                 : trial.scores().front().error_text);
    EvaluatedCandidate best = refine_repeatedly(std::move(evaluated.front()), trial);
    // The best candidate before refinement need not be the best after it.
    if (evaluated.size() > 1 && average(best.errors_percent) > kGoodEnough_percent) {
        EvaluatedCandidate other = refine_repeatedly(std::move(evaluated[1]), trial);
        if (is_better(other, best, kModelStandardErrors)) best = std::move(other);
    }
    return ModelSelection{trial.release_scores(), best.score, std::move(best.candidate)};
}

}  // namespace gsim::calibrate
