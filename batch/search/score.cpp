#include "batch/search/score.h"

#include <algorithm>
#include <cmath>

#include "base/text/format.h"
#include "batch/search/figures.h"

namespace gsim::batch {

namespace {

using Fault = tl::unexpected<std::string>;

// Classes of violations, each worse than the previous ones: past limits, ended before the end, not begun.
constexpr double kMostExcess = 1e5, kEnded = 1e6, kNotBegun = 1e9;

bool has_figures(const RunFigures& run) {
    return run.status == "completed" || run.status == "violations";
}

/// Returns the violation of a single run.
double violation_of(const RunFigures& run) {
    if (run.is_clean()) return 0;
    if (has_figures(run)) return std::max(1.0, run.figure("violations") + run.figure("collisions"));
    // A run that gets farther is closer to a valid one.
    if (run.status == "alarm" || run.status == "stopped") return kEnded + kEnded / (1 + run.figure("blocks"));
    return kNotBegun;
}

/// Returns the excess of a metric beyond its limit, as a share of the limit.
double excess(const FigureLimit& limit, const RunFigures& run) {
    const auto found = run.figures.find(limit.figure);
    if (found == run.figures.end() || !found->second) return kMostExcess;
    const auto beyond = [](double by, double bound) {
        return by > 0 ? std::min(by / std::max(std::abs(bound), 1e-3), kMostExcess) : 0.0;
    };
    double excess = 0;
    if (limit.least) excess += beyond(*limit.least - *found->second, *limit.least);
    if (limit.most) excess += beyond(*found->second - *limit.most, *limit.most);
    return excess;
}

}  // namespace

double RunFigures::figure(std::string_view name, double fallback) const {
    const auto found = figures.find(name);
    return found == figures.end() ? fallback : found->second.value_or(fallback);
}

tl::expected<std::vector<RunFigures>, std::string> read_figures(Database& results, std::int64_t batch,
                                                                std::uint64_t jobs) {
    auto rows = results.prepare(
        fmt::format("SELECT run.id, status, cause, message, program, {} FROM batch_run JOIN run ON run.id = "
                    "batch_run.run WHERE batch = ? ORDER BY job",
                    text::joined(kFigures, ", ")));
    if (!rows) return Fault(rows.error());
    rows->bind(1, batch);
    std::vector<RunFigures> found;
    while (true) {
        const auto row = rows->step();
        if (!row) return Fault(row.error());
        if (!*row) break;
        RunFigures& run = found.emplace_back(RunFigures{.run = rows->whole(0),
                                                        .status = std::string(rows->text(1)),
                                                        .cause = std::string(rows->text(2)),
                                                        .message = std::string(rows->text(3)),
                                                        .program = std::string(rows->text(4)),
                                                        .figures = {}});
        for (std::size_t i = 0; i < kFigures.size(); ++i) {
            const int column = static_cast<int>(i) + 5;
            run.figures[std::string(kFigures[i])] =
                rows->is_null(column) ? std::nullopt : std::optional(rows->number(column));
        }
    }
    if (found.size() != jobs) return Fault(fmt::format("{} of {} runs have been made", found.size(), jobs));
    return found;
}

bool was_not_begun(const RunFigures& run) {
    return violation_of(run) >= kNotBegun;
}

Score score_of(const SearchPlan& search, std::span<const RunFigures> runs,
               std::span<const RunFigures> start) {
    Score score{.value = 0};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RunFigures& run = runs[i];
        score.violation += violation_of(run);
        if (!has_figures(run)) {
            score.value.reset();
            continue;
        }
        for (const Weight& weight : search.objective) {
            if (score.value) *score.value += weight.weight * run.figure(weight.figure);
        }
        for (const FigureLimit& limit : search.limits) score.violation += excess(limit, run);
        const double more = run.figure("process_findings") - start[i].figure("process_findings");
        if (has_figures(start[i]) && more > 0) score.violation += more;
    }
    return score;
}

std::string find_missing_figure(const SearchPlan& search, std::span<const RunFigures> runs) {
    std::vector<std::string> wanted;
    for (const Weight& weight : search.objective) wanted.push_back(weight.figure);
    for (const FigureLimit& limit : search.limits) wanted.push_back(limit.figure);
    for (const RunFigures& run : runs) {
        if (!has_figures(run)) continue;
        for (const std::string& figure : wanted) {
            if (!run.figures.at(figure))
                return fmt::format(
                    "runs of '{}' have no '{}' (docs/optimise.md tells what each figure needs)", run.program,
                    figure);
        }
    }
    return {};
}

}  // namespace gsim::batch
