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

using Done = tl::expected<void, std::string>;
using Eigen::VectorXd;
using Fault = tl::unexpected<std::string>;
using Variants = std::vector<std::vector<SettingValue>>;

constexpr double kFirstStep = 0.2, kLaterStep = 0.3;  // of the box
constexpr std::uint64_t kFirstOfDimension = 10;
constexpr std::uint64_t kMostFirst = 200;

std::string objective_text(const SearchPlan& search) {
    nlohmann::ordered_json text = nlohmann::ordered_json::object();
    for (const Weight& weight : search.objective) text[weight.figure] = weight.weight;
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

    tl::expected<SearchState, std::string> run() {
        return begin()
            .and_then([&] { return explore(); })
            .and_then([&] { return evolve(); })
            .and_then([&] { return end(); })
            .map([&] { return std::move(state_); });
    }

  private:
    /// Tries variants; returns their indices from the best one on. Empty: the search was cut off.
    tl::expected<std::vector<std::size_t>, std::string> try_all(const Variants& variants) {
        const Plan plan = with_variants(search_.plan, variants);
        const auto evaluated = evaluate_(plan, false);
        if (!evaluated) return Fault(evaluated.error());
        if (!evaluated->whole) return std::vector<std::size_t>();
        auto results = Database::open(results_);
        if (!results) return Fault(results.error());
        const auto runs = read_figures(*results, evaluated->batch, Jobs(plan).size());
        if (!runs) return Fault(runs.error());
        return take(*results, variants, *runs);
    }

    tl::expected<std::vector<std::size_t>, std::string> take(Database& results, const Variants& variants,
                                                             const std::vector<RunFigures>& runs) {
        const bool is_start = state_.tried == 0;
        if (is_start) {
            auto begun = begin_search(results, search_.plan.name, objective_text(search_), search_.seed);
            if (!begun) return Fault(begun.error());
            state_.search = *begun;
        }
        // A metric that the start lacks is an error of the plan; a variant without a metric is not allowed.
        if (const std::string missing = is_start ? find_missing_figure(search_, runs) : ""; !missing.empty())
            return Fault(missing);
        std::vector<Score> scores;
        std::vector<TrialRow> rows;
        for (std::size_t i = 0; i < variants.size(); ++i) {
            Trial trial{.settings = variants[i], .score = {}, .runs = {}};
            // All variants of a program on one machine are consecutive.
            for (std::size_t at = i; at < runs.size(); at += variants.size()) trial.runs.push_back(runs[at]);
            trial.score = score_of(search_, trial.runs, is_start ? trial.runs : state_.start.runs);
            scores.push_back(trial.score);
            for (const RunFigures& run : trial.runs)
                rows.push_back(
                    {state_.tried, run.run, state_.generation, trial.score.value, trial.score.violation});
            if (!is_start) note_refusals(trial);
            take(std::move(trial), is_start);
        }
        if (const Done added = add_trials(results, state_.search, rows); !added) return Fault(added.error());
        progress_(state_);
        std::vector<std::size_t> places(variants.size());
        std::iota(places.begin(), places.end(), std::size_t{0});
        std::stable_sort(places.begin(), places.end(),
                         [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
        return places;
    }

    /// Records a setting that no run can have, so that it is reported early.
    void note_refusals(const Trial& trial) {
        for (const RunFigures& run : trial.runs) {
            const bool refused = was_not_begun(run);
            begun_ += refused ? 0 : 1;
            if (refused && refused_.empty()) refused_ = fmt::format("{}: {}", run.program, run.message);
        }
    }

    void take(Trial trial, bool is_start) {
        state_.allowed += trial.score.is_allowed() ? 1 : 0;
        if (is_start) state_.start = trial;
        if (is_start || trial.score < state_.best.score) {
            state_.best = std::move(trial);
            state_.best_number = state_.tried;
        }
        ++state_.tried;
    }

    Done begin() {
        const auto tried = try_all({{}});
        if (!tried) return Fault(tried.error());
        cut_off_ = tried->empty();
        return {};
    }

    std::uint64_t left() const {
        const std::uint64_t done = state_.tried - 1;  // but for the start
        return done < search_.variants ? search_.variants - done : 0;
    }

    Variants variants_at(const std::vector<VectorXd>& points) const {
        Variants variants;
        for (const VectorXd& point : points) variants.push_back(space_.variant(point));
        return variants;
    }

    Done explore() {
        if (cut_off_) return {};
        // The number does not depend on the total, so that a search with more variants continues one with
        // fewer.
        std::uint64_t count = search_.first;
        if (count == 0) count = std::min(kFirstOfDimension * space_.dimensions(), kMostFirst);
        count = std::min(count, left());
        const std::vector<VectorXd> points = spread_points(space_.dimensions(), count, search_.seed);
        const auto places = try_all(variants_at(points));
        if (!places) return Fault(places.error());
        cut_off_ = places->empty();
        if (cut_off_) return {};
        if (!refused_.empty() && begun_ == 0)
            return Fault(fmt::format("each of the {} first variants is refused: {}", count, refused_));
        begin_at_ = points[places->front()];
        return {};
    }

    Done evolve() {
        VectorXd mean = begin_at_;
        double step = kFirstStep;
        for (std::size_t population = search_.population; !cut_off_ && left() > 0;) {
            Evolution evolution(mean, step, population, Random(random_()));
            while (!cut_off_ && left() > 0 && !evolution.is_done()) {
                if (Done done = evolve_once(evolution); !done) return done;
            }
            population = 2 * evolution.population();
            for (double& each : mean) each = lot(random_);
            step = kLaterStep;
        }
        return {};
    }

    Done evolve_once(Evolution& evolution) {
        std::vector<VectorXd> points = evolution.ask();
        const bool whole = points.size() <= left();
        if (!whole) points.resize(left());
        ++state_.generation;
        const auto places = try_all(variants_at(points));
        if (!places) return Fault(places.error());
        cut_off_ = places->empty();
        if (!cut_off_ && whole) evolution.tell(*places);
        return {};
    }

    Done end() {
        state_.whole = !cut_off_;
        if (state_.tried == 0) return {};
        auto results = Database::open(results_);
        if (!results) return Fault(results.error());
        return end_search(*results, state_.search, state_.best_number);
    }

    const SearchPlan& search_;
    const std::string& results_;
    const Evaluate& evaluate_;
    const std::function<void(const SearchState&)>& progress_;
    Space space_;
    Random random_;
    VectorXd begin_at_;
    SearchState state_;
    bool cut_off_ = false;
    std::uint64_t begun_ = 0;  // runs of variants that were begun
    std::string refused_;      // why the first refused run was refused
};

}  // namespace

tl::expected<SearchState, std::string> search_best(const SearchPlan& search, const std::string& results,
                                                   const Evaluate& evaluate,
                                                   const std::function<void(const SearchState&)>& progress) {
    return BestSearch(search, results, evaluate, progress).run();
}

}  // namespace gsim::batch
