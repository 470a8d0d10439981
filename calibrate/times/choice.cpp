#include "calibrate/times/choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

constexpr std::size_t kTried = 3;             // of all candidates, by cross-validation
constexpr double kNear = 1.25;                // of the best fit's error: what comes so near is tried, too
constexpr std::size_t kRefined = 4;           // max iterations
constexpr double kWorthTrying = 0.95;         // of the fit's error: what lessens it by less is not tried
constexpr int kMaxChoiceSteps = 12;           // of a fit; what is chosen is fitted to its end
constexpr int kStepsOfPart = 3;               // from what was fitted to all runs
constexpr double kErrorsOfKind = 1;           // standard errors
constexpr double kErrorsOfRefinement = 2;     // of which there are many, so that one may seem to help
constexpr double kPlainGain_percent = 0.1;    // required in addition
constexpr double kPlainGain = 0.1;            // of the mean error
constexpr double kGoodEnough_percent = 0.3;   // in the mean: then the second best is not refined
constexpr double kNearEnough_percent = 0.02;  // in the mean: less is not looked for

/// Returns the indices of the runs in one of several parts, or of those outside it.
std::vector<std::size_t> places_of(std::size_t runs, std::size_t parts, std::size_t part, bool inside) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < runs; ++i) {
        if ((i % parts == part) == inside) places.push_back(i);
    }
    return places;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Candidate that has been tried.
struct Tried {
    Candidate candidate;  ///< As fitted to all runs.
    std::size_t score = 0;
    std::vector<double> errors_percent;  ///< For each run, predicted by a fit to others.
};

/// Trial of candidates on runs, with their results.
class Trial {
  public:
    Trial(std::span<const RecordedRun> runs, const Predictor& predictor, std::size_t parts,
          const std::function<void(const std::string&)>& told)
        : runs_(runs), predictor_(predictor), parts_(parts), told_(told) {}

    /// Fits a candidate to all runs; empty if that is impossible.
    std::optional<Tried> fit(const Candidate& candidate) {
        scores_.push_back({candidate.name});
        Score& score = scores_.back();
        const auto fit = fit_times(candidate.machine, runs_, predictor_, {candidate.open, kMaxChoiceSteps});
        if (fit) {
            for (std::size_t i = 0; i < runs_.size(); ++i)
                score.fitted_percent +=
                    std::abs(runs_[i].error_percent(fit->times_s[i])) / static_cast<double>(runs_.size());
        } else {
            score.refused = fit.error();
        }
        tell(score);
        if (!fit) return std::nullopt;
        return Tried{{candidate.name, fit->machine, candidate.open}, scores_.size() - 1, {}};
    }

    /// Returns true if all parts could be predicted.
    bool cross_validate(Tried& tried) {
        Score& score = scores_[tried.score];
        tried.errors_percent.assign(runs_.size(), 0);
        for (std::size_t part = 0; part < parts_; ++part) {
            if (const auto done = foretell(tried, part); !done) {
                score.refused = done.error();
                tell(score);
                return false;
            }
        }
        score.foretells = true;
        score.mean_percent = mean_of(tried.errors_percent);
        score.largest_percent = *std::max_element(tried.errors_percent.begin(), tried.errors_percent.end());
        tell(score);
        return true;
    }

    double fitted_percent(const Tried& tried) const { return scores_[tried.score].fitted_percent; }
    /// Returns keys of [times].
    std::vector<std::string> words() const { return predictor_.words(); }
    std::vector<Score> take_scores() { return std::move(scores_); }
    const std::vector<Score>& scores() const { return scores_; }

  private:
    tl::expected<void, std::string> foretell(Tried& tried, std::size_t part) const {
        const auto others = places_of(runs_.size(), parts_, part, false);
        const auto places = places_of(runs_.size(), parts_, part, true);
        const auto fit = fit_times(tried.candidate.machine, runs_at(runs_, others), predictor_.part(others),
                                   {tried.candidate.open, kStepsOfPart});
        if (!fit) return tl::unexpected(fit.error());
        const auto times = predictor_.part(places).times_s(fit->machine);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const RecordedRun& run = runs_[places[i]];
            if (!times[i]) return tl::unexpected(fmt::format("{}: {}", run.program, times[i].error()));
            tried.errors_percent[places[i]] = std::abs(run.error_percent(*times[i]));
        }
        return {};
    }

    void tell(const Score& score) const {
        if (!told_) return;
        if (!score.refused.empty()) return told_(fmt::format("{}: {}", score.name, score.refused));
        if (!score.foretells)
            return told_(fmt::format("{}: fitted to {:.2f} % in the mean", score.name, score.fitted_percent));
        told_(fmt::format("{}: foretells to {:.2f} % in the mean, {:.2f} % at worst", score.name,
                          score.mean_percent, score.largest_percent));
    }

    std::span<const RecordedRun> runs_;
    const Predictor& predictor_;
    std::size_t parts_;
    const std::function<void(const std::string&)>& told_;
    std::vector<Score> scores_;
};

/// Returns true if `other` predicts better: by a tenth, or by so many standard errors of the differences.
bool is_better(const Tried& other, const Tried& than, double standard_errors) {
    std::vector<double> gains;
    for (std::size_t i = 0; i < other.errors_percent.size(); ++i)
        gains.push_back(than.errors_percent[i] - other.errors_percent[i]);
    const double mean = mean_of(gains);
    if (mean > kPlainGain * mean_of(than.errors_percent) && mean > kPlainGain_percent) return true;
    double squares = 0;
    for (const double gain : gains) squares += (gain - mean) * (gain - mean);
    const auto count = static_cast<double>(gains.size());
    return mean > standard_errors * std::sqrt(squares / (count * (count - 1)));
}

/// Sorts by the distance to the runs, the smallest first.
void sort_by_fit(std::vector<Tried>& tried, const Trial& trial) {
    std::stable_sort(tried.begin(), tried.end(), [&](const Tried& a, const Tried& b) {
        return trial.fitted_percent(a) < trial.fitted_percent(b);
    });
}

/// Returns the candidates that could be cross-validated: the preferred one first, then the others by the
/// quality of their predictions.
std::vector<Tried> tried_candidates(std::span<const Candidate> candidates, Trial& trial) {
    std::vector<Tried> fitted;
    for (const Candidate& candidate : candidates) {
        if (auto tried = trial.fit(candidate)) fitted.push_back(*std::move(tried));
    }
    sort_by_fit(fitted, trial);
    const auto is_near = [&](std::size_t place) {
        return trial.fitted_percent(fitted[place]) < kNear * trial.fitted_percent(fitted.front());
    };
    std::size_t count = std::min(fitted.size(), kTried);
    while (count < fitted.size() && is_near(count)) ++count;
    fitted.resize(count);
    std::erase_if(fitted, [&](Tried& each) { return !trial.cross_validate(each); });
    std::sort(fitted.begin(), fitted.end(), [](const Tried& a, const Tried& b) { return a.score < b.score; });
    std::size_t best = 0;
    for (std::size_t i = 1; i < fitted.size(); ++i) {
        if (is_better(fitted[i], fitted[best], kErrorsOfKind)) best = i;
    }
    if (fitted.empty()) return fitted;
    std::rotate(fitted.begin(), fitted.begin() + static_cast<std::ptrdiff_t>(best),
                fitted.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    std::stable_sort(fitted.begin() + 1, fitted.end(), [](const Tried& a, const Tried& b) {
        return mean_of(a.errors_percent) < mean_of(b.errors_percent);
    });
    return fitted;
}

/// Returns the model with the one addition that makes it predict better; empty if none does.
std::optional<Tried> refined(const Tried& tried, Trial& trial) {
    std::vector<Tried> fitted;
    const double worth_percent = kWorthTrying * trial.fitted_percent(tried);
    for (const Candidate& candidate : refinements(tried.candidate, trial.words())) {
        auto found = trial.fit(candidate);
        if (found && trial.fitted_percent(*found) < worth_percent) fitted.push_back(*std::move(found));
    }
    sort_by_fit(fitted, trial);
    for (Tried& found : fitted) {
        if (trial.cross_validate(found) && is_better(found, tried, kErrorsOfRefinement))
            return std::move(found);
    }
    return std::nullopt;
}

/// Adds refinements as long as they make it predict better.
Tried refined_to_its_end(Tried tried, Trial& trial) {
    for (std::size_t i = 0; i < kRefined && trial.fitted_percent(tried) > kNearEnough_percent; ++i) {
        auto better = refined(tried, trial);
        if (!better) break;
        tried = *std::move(better);
    }
    return tried;
}

}  // namespace

tl::expected<Choice, std::string> choose_model(std::span<const Candidate> candidates,
                                               std::span<const RecordedRun> runs, const Predictor& predictor,
                                               std::size_t parts,
                                               const std::function<void(const std::string&)>& told) {
    Trial trial(runs, predictor, parts, told);
    std::vector<Tried> tried = tried_candidates(candidates, trial);
    if (tried.empty())
        return tl::unexpected(candidates.empty() ? std::string("there is no model to choose from")
                                                 : trial.scores().front().refused);
    Tried best = refined_to_its_end(std::move(tried.front()), trial);
    // The best candidate before refinement need not be the best after it.
    if (tried.size() > 1 && mean_of(best.errors_percent) > kGoodEnough_percent) {
        Tried other = refined_to_its_end(std::move(tried[1]), trial);
        if (is_better(other, best, kErrorsOfKind)) best = std::move(other);
    }
    return Choice{trial.take_scores(), best.score, std::move(best.candidate)};
}

}  // namespace gsim::calibrate
