#include "batch/search/search.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/text/json.h"
#include "batch/plan/design.h"
#include "batch/search/evolution.h"
#include "batch/search/space.h"
#include "batch/store/searches.h"

namespace gsim::batch {

namespace {

using Eigen::VectorXd;
using Variants = std::vector<std::vector<SettingValue>>;

constexpr double kInitialStep = 0.2, kRestartStep = 0.3;  // of the box
constexpr std::uint64_t kInitialPerDimension = 10;
constexpr std::uint64_t kMaxInitial = 200;

std::string objective_text(const SearchPlan& search) {
    nlohmann::ordered_json text = nlohmann::ordered_json::object();
    for (const Weight& weight : search.objective) text[weight.metric] = weight.weight;
    return text.dump();
}

/// Returns evenly spread points of Sobol's sequence. A longer list begins with the points of a shorter one.
std::vector<VectorXd> spread_points(std::size_t dimensions, std::uint64_t count, std::uint64_t seed) {
    const std::vector<Setting> coordinates(dimensions, Setting{{""}, Uniform{0, 1}});
    const Design design(coordinates, {.sampling = Sampling::sobol, .runs = count, .seed = seed});
    std::vector<VectorXd> points;
    for (std::uint64_t i = 0; i < count; ++i) {
        VectorXd& point = points.emplace_back(static_cast<Eigen::Index>(dimensions));
        const std::vector<SettingValue> values = design.variant(i);
        for (std::size_t d = 0; d < dimensions; ++d) point[static_cast<Eigen::Index>(d)] = values[d].value;
    }
    return points;
}

class BestSearch {
  public:
    BestSearch(const SearchPlan& search, const std::string& results, const Evaluate& evaluate,
               const std::function<void(const SearchState&)>& progress)
        : search_(search),
          results_(results),
          evaluate_(evaluate),
          progress_(progress),
          space_(search.plan.settings),
          random_(search.seed) {}

    Result<SearchState> run() {
        return begin()
            .and_then([&] { return explore(); })
            .and_then([&] { return evolve(); })
            .and_then([&] { return end(); })
            .map([&] { return std::move(state_); });
    }

  private:
    /// Tries variants; returns their indices from the best one on. Empty: the search was cut off.
    Result<std::vector<std::size_t>> rank_variants(const Variants& variants) {
        const Plan plan = with_variants(search_.plan, variants);
        const auto evaluated_batch = evaluate_(plan, false);
        if (!evaluated_batch) return Unexpected(evaluated_batch.error());
        if (!evaluated_batch->complete) return std::vector<std::size_t>();
        auto results = Database::open(results_);
        if (!results) return Unexpected(results.error());
        const auto runs = read_metrics(*results, evaluated_batch->batch, Jobs(plan).size());
        if (!runs) return Unexpected(runs.error());
        return record_trials(*results, variants, *runs);
    }

    Result<std::vector<std::size_t>> record_trials(Database& results, const Variants& variants,
                                                   const std::vector<RunMetrics>& runs) {
        const bool is_start = state_.trials == 0;
        if (is_start) {
            auto begun = begin_search(results, search_.plan.name, objective_text(search_), search_.seed);
            if (!begun) return Unexpected(begun.error());
            state_.search = *begun;
        }
        // A metric that the start lacks is an error of the plan; a variant without a metric is not allowed.
        if (is_start) {
            if (auto missing = find_missing_metric(search_, runs)) return tl::unexpected(*std::move(missing));
        }
        std::vector<Score> scores;
        std::vector<TrialRow> rows;
        for (std::size_t i = 0; i < variants.size(); ++i) {
            Trial trial{.settings = variants[i], .score = {}, .runs = {}};
            // All variants of a program on one machine are consecutive.
            for (std::size_t at = i; at < runs.size(); at += variants.size()) trial.runs.push_back(runs[at]);
            trial.score = compute_score(search_, trial.runs, is_start ? trial.runs : state_.start.runs);
            scores.push_back(trial.score);
            for (const RunMetrics& run : trial.runs)
                rows.push_back(
                    {state_.trials, run.run, state_.generation, trial.score.value, trial.score.violation});
            if (!is_start) record_rejections(trial);
            record_trials(std::move(trial), is_start);
        }
        if (const Result<void> result = add_trials(results, state_.search, rows); !result)
            return Unexpected(result.error());
        progress_(state_);
        std::vector<std::size_t> ranking(variants.size());
        std::iota(ranking.begin(), ranking.end(), std::size_t{0});
        std::stable_sort(ranking.begin(), ranking.end(),
                         [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
        return ranking;
    }

    /// Records a setting that no run can have, so that it is reported early.
    void record_rejections(const Trial& trial) {
        for (const RunMetrics& run : trial.runs) {
            const bool rejected = was_not_started(run);
            started_runs_ += rejected ? 0 : 1;
            if (rejected && rejection_.empty()) rejection_ = fmt::format("{}: {}", run.program, run.message);
        }
    }

    void record_trials(Trial trial, bool is_start) {
        state_.feasible += trial.score.is_feasible() ? 1 : 0;
        if (is_start) state_.start = trial;
        if (is_start || trial.score < state_.best.score) {
            state_.best = std::move(trial);
            state_.best_number = state_.trials;
        }
        ++state_.trials;
    }

    Result<void> begin() {
        const auto trials = rank_variants({{}});
        if (!trials) return Unexpected(trials.error());
        is_interrupted_ = trials->empty();
        return {};
    }

    std::uint64_t remaining() const {
        const std::uint64_t done = state_.trials - 1;  // but for the start
        return done < search_.variants ? search_.variants - done : 0;
    }

    Variants variants_at(const std::vector<VectorXd>& points) const {
        Variants variants;
        for (const VectorXd& point : points) variants.push_back(space_.variant(point));
        return variants;
    }

    Result<void> explore() {
        if (is_interrupted_) return {};
        // The number does not depend on the total, so that a search with more variants continues one with
        // fewer.
        std::uint64_t count = search_.first;
        if (count == 0) count = std::min(kInitialPerDimension * space_.dimensions(), kMaxInitial);
        count = std::min(count, remaining());
        const std::vector<VectorXd> points = spread_points(space_.dimensions(), count, search_.seed);
        const auto ranking = rank_variants(variants_at(points));
        if (!ranking) return Unexpected(ranking.error());
        is_interrupted_ = ranking->empty();
        if (is_interrupted_) return {};
        if (!rejection_.empty() && started_runs_ == 0)
            return Unexpected(
                fmt::format("each of the {} first variants is rejected: {}", count, rejection_));
        start_point_ = points[ranking->front()];
        return {};
    }

    Result<void> evolve() {
        VectorXd mean = start_point_;
        double step = kInitialStep;
        for (std::size_t population = search_.population; !is_interrupted_ && remaining() > 0;) {
            Evolution evolution(mean, step, population, Random(random_()));
            while (!is_interrupted_ && remaining() > 0 && !evolution.has_converged()) {
                if (Result<void> done = evolve_once(evolution); !done) return done;
            }
            population = 2 * evolution.population();
            for (double& each : mean) each = uniform_random(random_);
            step = kRestartStep;
        }
        return {};
    }

    Result<void> evolve_once(Evolution& evolution) {
        std::vector<VectorXd> points = evolution.sample_population();
        const bool complete = points.size() <= remaining();
        if (!complete) points.resize(remaining());
        ++state_.generation;
        const auto ranking = rank_variants(variants_at(points));
        if (!ranking) return Unexpected(ranking.error());
        is_interrupted_ = ranking->empty();
        if (!is_interrupted_ && complete) evolution.update(*ranking);
        return {};
    }

    Result<void> end() {
        state_.complete = !is_interrupted_;
        if (state_.trials == 0) return {};
        auto results = Database::open(results_);
        if (!results) return Unexpected(results.error());
        return end_search(*results, state_.search, state_.best_number);
    }

    const SearchPlan& search_;
    const std::string& results_;
    const Evaluate& evaluate_;
    const std::function<void(const SearchState&)>& progress_;
    SearchSpace space_;
    Random random_;
    VectorXd start_point_;
    SearchState state_;
    bool is_interrupted_ = false;
    std::uint64_t started_runs_ = 0;  // runs of variants that were begun
    std::string rejection_;           // why the first refused run was refused
};

}  // namespace

Result<SearchState> search_best(const SearchPlan& search, const std::string& results,
                                const Evaluate& evaluate,
                                const std::function<void(const SearchState&)>& progress) {
    return BestSearch(search, results, evaluate, progress).run();
}

}  // namespace gsim::batch
