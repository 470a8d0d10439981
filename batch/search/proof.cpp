#include "batch/search/proof.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr double kSame = 1e-9;

class Prover {
  public:
    Prover(const SearchPlan& search, const SearchState& state, const std::string& results,
           const Evaluate& evaluate)
        : search_(search), start_(state.start.runs), results_(results), evaluate_(evaluate) {}

    /// Repeats the runs of a variant as in the search, but with more reports.
    tl::expected<Proof::Bounded, std::string> again(const Trial& trial) {
        const Plan plan = with_variants(with_more(search_.plan), {trial.settings});
        return runs_of(plan).and_then([&](const auto& runs) { return compared(trial, runs); });
    }

    tl::expected<Proof::Bounded, std::string> from_files(const Trial& trial, const std::vector<Job>& files) {
        std::vector<RunFigures> runs;
        for (const Job& job : files) {
            Plan plan = search_.plan;
            plan.programs = {job.program};
            plan.machines = {job.machine};
            plan.options = job.options;
            auto made = runs_of(with_variants(with_more(std::move(plan)), {{}}));
            if (!made) return Fault(made.error());
            runs.insert(runs.end(), made->begin(), made->end());
        }
        return compared(trial, runs);
    }

  private:
    static Plan with_more(Plan plan) {
        plan.options["lower_bound"] = true;
        plan.keeps.report = true;
        return plan;
    }

    tl::expected<std::vector<RunFigures>, std::string> runs_of(const Plan& plan) {
        const auto evaluated = evaluate_(plan, true);
        if (!evaluated) return Fault(evaluated.error());
        if (!evaluated->whole) return Fault("cut off before the best variant was proven");
        auto results = Database::open(results_, true);
        if (!results) return Fault(results.error());
        return read_figures(*results, evaluated->batch, Jobs(plan).size());
    }

    /// Checks that all metrics that both have are the same.
    tl::expected<Proof::Bounded, std::string> compared(const Trial& trial,
                                                       const std::vector<RunFigures>& runs) const {
        Proof::Bounded bounded{.value = score_of(search_, runs, start_).value, .lower_bound_s = 0};
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (const std::string fault = difference(trial.runs[i], runs[i]); !fault.empty())
                return Fault(fault);
            const auto& bound = runs[i].figures.at("lower_bound_s");
            bounded.lower_bound_s = bound && bounded.lower_bound_s
                                        ? std::optional(*bounded.lower_bound_s + *bound)
                                        : std::nullopt;
        }
        return bounded;
    }

    static std::string difference(const RunFigures& tried, const RunFigures& again) {
        if (tried.status != again.status || tried.cause != again.cause)
            return fmt::format(
                "a run of its own of '{}' ends otherwise than in the search: {} {} in place of {} {}{}",
                again.program, again.status, again.cause, tried.status, tried.cause,
                again.message.empty() ? "" : " (" + again.message + ")");
        for (const auto& [figure, value] : tried.figures) {
            const auto& other = again.figures.at(figure);
            if (!value || (other && std::abs(*other - *value) <= kSame * std::max(1.0, std::abs(*value))))
                continue;
            return fmt::format("a run of its own of '{}' has {} {} where the search had {}", again.program,
                               figure, other ? fmt::format("{}", *other) : "none", *value);
        }
        return {};
    }

    const SearchPlan& search_;
    const std::vector<RunFigures>& start_;
    const std::string& results_;
    const Evaluate& evaluate_;
};

}  // namespace

tl::expected<Proof, std::string> prove(const SearchPlan& search, const SearchState& state,
                                       const std::string& results, const std::string& folder,
                                       const Evaluate& evaluate) {
    Prover prover(search, state, results, evaluate);
    Proof proof;
    auto start = prover.again(state.start);
    if (!start) return Fault(start.error());
    proof.start = *start;
    if (!folder.empty()) {
        auto files = write_variant(search.plan, state.best.settings, folder);
        if (!files) return Fault(files.error());
        proof.files = *std::move(files);
    }
    auto best = folder.empty() ? prover.again(state.best) : prover.from_files(state.best, proof.files);
    if (!best) return Fault(best.error());
    proof.best = *best;
    return proof;
}

}  // namespace gsim::batch
