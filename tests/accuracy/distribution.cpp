#include "tests/accuracy/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "tests/accuracy/table.h"

namespace gsim::accuracy {

namespace {

constexpr Tolerance kWithin{0.5, 0.005};

double sample_quantile(const std::vector<double>& sorted, double share) {
    const double place = std::ceil(share * static_cast<double>(sorted.size())) - 1;
    return sorted[static_cast<std::size_t>(std::max(place, 0.0))];
}

std::string percent(double value) {
    return std::isfinite(value) ? fmt::format("{:.3f}", value) : "-";
}

}  // namespace

Distribution distribution_of(const std::vector<TimeOutcome>& outcomes) {
    Distribution all;
    std::vector<double> errors;
    for (const TimeOutcome& outcome : outcomes) {
        if (!outcome.counted) continue;
        const double error =
            outcome.found_s ? outcome.error_percent() : std::numeric_limits<double>::infinity();
        errors.push_back(std::abs(error));
        if (!outcome.found_s) continue;
        if (kWithin.is_within(outcome.error_s(), outcome.recorded_s)) ++all.within;
        if (all.largest.empty() || std::abs(error) > std::abs(all.largest_percent)) {
            all.largest_percent = error;
            all.largest = outcome.name;
        }
    }
    all.count = errors.size();
    if (errors.empty()) return all;
    std::sort(errors.begin(), errors.end());
    all.median_percent = sample_quantile(errors, 0.5);
    all.p95_percent = sample_quantile(errors, 0.95);
    return all;
}

std::string distribution_table(const std::vector<EstimatedController>& rows, bool markdown) {
    const std::vector<Column> columns{{"controller", Align::left},
                                      {"estimate", Align::left},
                                      {"runs", Align::right},
                                      {"median %", Align::right},
                                      {"95 of 100 within %", Align::right},
                                      {"within 0.5 % or 5 ms", Align::right},
                                      {"largest %", Align::right},
                                      {"of", Align::left}};
    std::vector<Row> cells;
    for (const auto& [controller, estimator, all] : rows) {
        cells.push_back({controller, estimator, fmt::format("{}", all.count), percent(all.median_percent),
                         percent(all.p95_percent), fmt::format("{}", all.within),
                         fmt::format("{:+.1f}", all.largest_percent), all.largest});
    }
    return markdown ? markdown_table(columns, cells) : plain_table(columns, cells);
}

}  // namespace gsim::accuracy
