#include "batch/search/score.h"

#include <algorithm>
#include <cmath>

#include "base/text/format.h"
#include "batch/search/metrics.h"

namespace gsim::batch {

namespace {

// Classes of violations, each worse than the previous ones: past limits, ended before the end, not begun.
constexpr double kMaxExcess = 1e5, kAbortedViolation = 1e6, kNotStartedViolation = 1e9;

bool has_metrics(const RunMetrics& run) {
    return run.status == "completed" || run.status == "violations";
}

/// Returns the violation of a single run.
double violation_of(const RunMetrics& run) {
    if (run.is_clean()) return 0;
    if (has_metrics(run)) return std::max(1.0, run.metric("violations") + run.metric("collisions"));
    // A run that gets farther is closer to a valid one.
    if (run.status == "alarm" || run.status == "stopped")
        return kAbortedViolation + kAbortedViolation / (1 + run.metric("blocks"));
    return kNotStartedViolation;
}

/// Returns the excess of a metric beyond its limit, as a share of the limit.
double excess(const MetricLimit& limit, const RunMetrics& run) {
    const auto found = run.metrics.find(limit.metric);
    if (found == run.metrics.end() || !found->second) return kMaxExcess;
    const auto excess_share = [](double by, double bound) {
        return by > 0 ? std::min(by / std::max(std::abs(bound), 1e-3), kMaxExcess) : 0.0;
    };
    double excess = 0;
    if (limit.min) excess += excess_share(*limit.min - *found->second, *limit.min);
    if (limit.max) excess += excess_share(*found->second - *limit.max, *limit.max);
    return excess;
}

}  // namespace

double RunMetrics::metric(std::string_view name, double fallback) const {
    const auto found = metrics.find(name);
    return found == metrics.end() ? fallback : found->second.value_or(fallback);
}

Result<std::vector<RunMetrics>> read_metrics(Database& results, std::int64_t batch, std::uint64_t jobs) {
    auto rows = results.prepare(
        fmt::format("SELECT run.id, status, cause, message, program, {} FROM batch_run JOIN run ON run.id = "
                    "batch_run.run WHERE batch = ? ORDER BY job",
                    text::joined(kMetrics, ", ")));
    if (!rows) return Unexpected(rows.error());
    rows->bind(1, batch);
    std::vector<RunMetrics> found;
    while (true) {
        const auto row = rows->step();
        if (!row) return Unexpected(row.error());
        if (!*row) break;
        RunMetrics& run = found.emplace_back(RunMetrics{.run = rows->integer(0),
                                                        .status = std::string(rows->text(1)),
                                                        .cause = std::string(rows->text(2)),
                                                        .message = std::string(rows->text(3)),
                                                        .program = std::string(rows->text(4)),
                                                        .metrics = {}});
        for (std::size_t i = 0; i < kMetrics.size(); ++i) {
            const int column = static_cast<int>(i) + 5;
            run.metrics[std::string(kMetrics[i])] =
                rows->is_null(column) ? std::nullopt : std::optional(rows->number(column));
        }
    }
    if (found.size() != jobs)
        return Unexpected(fmt::format("{} of {} runs have been made", found.size(), jobs));
    return found;
}

bool was_not_started(const RunMetrics& run) {
    return violation_of(run) >= kNotStartedViolation;
}

Score compute_score(const SearchPlan& search, std::span<const RunMetrics> runs,
                    std::span<const RunMetrics> start) {
    Score score{.value = 0};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RunMetrics& run = runs[i];
        score.violation += violation_of(run);
        if (!has_metrics(run)) {
            score.value.reset();
            continue;
        }
        for (const Weight& weight : search.objective) {
            if (score.value) *score.value += weight.weight * run.metric(weight.metric);
        }
        for (const MetricLimit& limit : search.limits) score.violation += excess(limit, run);
        const double more = run.metric("process_findings") - start[i].metric("process_findings");
        if (has_metrics(start[i]) && more > 0) score.violation += more;
    }
    return score;
}

std::optional<Error> find_missing_metric(const SearchPlan& search, std::span<const RunMetrics> runs) {
    std::vector<std::string> required;
    for (const Weight& weight : search.objective) required.push_back(weight.metric);
    for (const MetricLimit& limit : search.limits) required.push_back(limit.metric);
    for (const RunMetrics& run : runs) {
        if (!has_metrics(run)) continue;
        for (const std::string& metric : required) {
            if (!run.metrics.at(metric))
                return fmt::format(
                    "runs of '{}' have no '{}' (docs/optimise.md lists the requirements of each metric)",
                    run.program, metric);
        }
    }
    return {};
}

}  // namespace gsim::batch
