#include "batch/search/verification_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsim::batch {

namespace {

constexpr double kTolerance = 1e-9;

class Verifier {
  public:
    Verifier(const SearchPlan& search, const SearchState& state, const std::string& results,
             const Evaluate& evaluate)
        : search_(search), start_runs_(state.start.runs), results_(results), evaluate_(evaluate) {}

    /// Repeats the runs of a variant as in the search, but with more reports.
    Result<VerificationRun::BoundedObjective> verify_variant(const Trial& trial) {
        const Plan plan = with_variants(with_reports(search_.plan), {trial.settings});
        return evaluate_runs(plan).and_then([&](const auto& runs) { return compare_runs(trial, runs); });
    }

    Result<VerificationRun::BoundedObjective> verify_files(const Trial& trial,
                                                           const std::vector<Job>& files) {
        std::vector<RunMetrics> runs;
        for (const Job& job : files) {
            Plan plan = search_.plan;
            plan.programs = {job.program};
            plan.machines = {job.machine};
            plan.options = job.options;
            auto runs_of_job = evaluate_runs(with_variants(with_reports(std::move(plan)), {{}}));
            if (!runs_of_job) return Unexpected(runs_of_job.error());
            runs.insert(runs.end(), runs_of_job->begin(), runs_of_job->end());
        }
        return compare_runs(trial, runs);
    }

  private:
    static Plan with_reports(Plan plan) {
        plan.options["lower_bound"] = true;
        plan.stored_documents.report = true;
        return plan;
    }

    Result<std::vector<RunMetrics>> evaluate_runs(const Plan& plan) {
        const auto evaluated_batch = evaluate_(plan, true);
        if (!evaluated_batch) return Unexpected(evaluated_batch.error());
        if (!evaluated_batch->complete)
            return Unexpected("interrupted before the verification run of the best variant ended");
        auto results = Database::open(results_, true);
        if (!results) return Unexpected(results.error());
        return read_metrics(*results, evaluated_batch->batch, Jobs(plan).size());
    }

    /// Checks that all metrics that both have are the same.
    Result<VerificationRun::BoundedObjective> compare_runs(const Trial& trial,
                                                           const std::vector<RunMetrics>& runs) const {
        VerificationRun::BoundedObjective bounded{.value = compute_score(search_, runs, start_runs_).value,
                                                  .lower_bound_s = 0};
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (const std::string mismatch = difference(trial.runs[i], runs[i]); !mismatch.empty())
                return Unexpected(mismatch);
            const auto& bound = runs[i].metrics.at("lower_bound_s");
            bounded.lower_bound_s = bound && bounded.lower_bound_s
                                        ? std::optional(*bounded.lower_bound_s + *bound)
                                        : std::nullopt;
        }
        return bounded;
    }

    static std::string difference(const RunMetrics& original, const RunMetrics& verify_variant) {
        if (original.status != verify_variant.status || original.cause != verify_variant.cause)
            return fmt::format(
                "the verification run of '{}' differs from the search: {} {} instead of {} {}{}",
                verify_variant.program, verify_variant.status, verify_variant.cause, original.status,
                original.cause, verify_variant.message.empty() ? "" : " (" + verify_variant.message + ")");
        for (const auto& [metric, value] : original.metrics) {
            const auto& other = verify_variant.metrics.at(metric);
            if (!value ||
                (other && std::abs(*other - *value) <= kTolerance * std::max(1.0, std::abs(*value))))
                continue;
            return fmt::format("the verification run of '{}' has {} {}, but the search had {}",
                               verify_variant.program, metric, other ? fmt::format("{}", *other) : "none",
                               *value);
        }
        return {};
    }

    const SearchPlan& search_;
    const std::vector<RunMetrics>& start_runs_;
    const std::string& results_;
    const Evaluate& evaluate_;
};

}  // namespace

Result<VerificationRun> verify_best(const SearchPlan& search, const SearchState& state,
                                    const std::string& results, const std::string& folder,
                                    const Evaluate& evaluate) {
    Verifier verifier(search, state, results, evaluate);
    VerificationRun verification_run;
    auto start = verifier.verify_variant(state.start);
    if (!start) return Unexpected(start.error());
    verification_run.start = *start;
    if (!folder.empty()) {
        auto files = write_variant(search.plan, state.best.settings, folder);
        if (!files) return Unexpected(files.error());
        verification_run.files = *std::move(files);
    }
    auto best = folder.empty() ? verifier.verify_variant(state.best)
                               : verifier.verify_files(state.best, verification_run.files);
    if (!best) return Unexpected(best.error());
    verification_run.best = *best;
    return verification_run;
}

}  // namespace gsim::batch
