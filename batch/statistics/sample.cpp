#include "batch/statistics/sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace gsim::batch {

namespace {

constexpr double kTailProbability = 0.025;  // beyond either end
constexpr std::array kPercentileShares{0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};
constexpr double kMaxBins = 60;
constexpr double kRelativePrecision = 0.01;
constexpr double kMaxRuns = 1e15;  // largest printed

double average(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(std::span<const double> values, double mean) {
    if (values.size() < 2) return 0;
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// Returns the half-width of the mean's interval, by Student's t.
double half_width(double deviation, std::size_t count) {
    const boost::math::students_t distribution(static_cast<double>(count - 1));
    return quantile(complement(distribution, kTailProbability)) * deviation /
           std::sqrt(static_cast<double>(count));
}

double sample_quantile(std::span<const double> sorted, double share) {
    const double index = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(index));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (index - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// The number of values below the percentile is binomial. The value at an index is above the percentile if
/// fewer values are below it.
Interval quantile_interval(std::span<const double> sorted, double share) {
    const boost::math::binomial below(static_cast<double>(sorted.size()), share);
    std::vector<std::size_t> indices(sorted.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    // Before `min` a value is above the percentile with a probability of at most kTailProbability, and from
    // `max` on one is below it.
    const auto min = std::partition_point(indices.begin(), indices.end(), [&](std::size_t index) {
        return cdf(below, static_cast<double>(index)) <= kTailProbability;
    });
    const auto max = std::partition_point(indices.begin(), indices.end(), [&](std::size_t index) {
        return cdf(complement(below, static_cast<double>(index))) > kTailProbability;
    });
    Interval interval;
    if (min != indices.begin()) interval.min = sorted[*std::prev(min)];
    if (max != indices.end()) interval.max = sorted[*max];
    return interval;
}

}  // namespace

SampleSummary summarize(std::vector<double> values) {
    SampleSummary summary;
    summary.count = values.size();
    summary.mean = average(values);
    summary.deviation = standard_deviation(values, summary.mean);
    if (values.size() > 1) {
        const double half = half_width(summary.deviation, values.size());
        summary.mean_interval = {summary.mean - half, summary.mean + half};
        if (summary.mean != 0) {
            const double needed =
                quantile(complement(boost::math::students_t(static_cast<double>(values.size() - 1)),
                                    kTailProbability)) *
                summary.deviation / (kRelativePrecision * std::abs(summary.mean));
            summary.runs_for_percent =
                static_cast<std::uint64_t>(std::ceil(std::clamp(needed * needed, 1.0, kMaxRuns)));
        }
    }
    std::sort(values.begin(), values.end());
    summary.min = values.front();
    summary.max = values.back();
    for (const double share : kPercentileShares)
        summary.percentiles.push_back(
            {share, sample_quantile(values, share), quantile_interval(values, share)});
    return summary;
}

Interval proportion_interval(std::uint64_t hits, std::uint64_t count) {
    using boost::math::beta_distribution;
    const auto k = static_cast<double>(hits), n = static_cast<double>(count);
    Interval interval{.min = 0.0, .max = 1.0};
    if (hits > 0) interval.min = quantile(beta_distribution<double>(k, n - k + 1), kTailProbability);
    if (hits < count)
        interval.max = quantile(complement(beta_distribution<double>(k + 1, n - k), kTailProbability));
    return interval;
}

std::vector<Bin> histogram(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double from = values.front(), to = values.back();
    if (!(to > from)) return {{from, to, values.size()}};
    const double interquartile_range = sample_quantile(values, 0.75) - sample_quantile(values, 0.25);
    const double width = 2 * interquartile_range / std::cbrt(static_cast<double>(values.size()));
    const double bin_count =
        width > 0 ? std::ceil((to - from) / width) : std::sqrt(static_cast<double>(values.size()));
    const auto count = static_cast<std::size_t>(std::clamp(bin_count, 1.0, kMaxBins));
    std::vector<Bin> bins(count);
    for (std::size_t i = 0; i < count; ++i)
        bins[i] = {from + (to - from) * static_cast<double>(i) / static_cast<double>(count),
                   from + (to - from) * static_cast<double>(i + 1) / static_cast<double>(count), 0};
    for (const double value : values) {
        const auto index =
            static_cast<std::size_t>((value - from) / (to - from) * static_cast<double>(count));
        ++bins[std::min(index, count - 1)].count;
    }
    return bins;
}

std::vector<Convergence> convergence(std::span<const double> values) {
    std::vector<Convergence> steps;
    for (std::size_t count = 8; !values.empty(); count *= 2) {
        const auto first = values.first(std::min(count, values.size()));
        const double mean = average(first);
        const double half = first.size() > 1 ? half_width(standard_deviation(first, mean), first.size()) : 0;
        steps.push_back({first.size(), mean, half});
        if (count >= values.size()) break;
    }
    return steps;
}

}  // namespace gsim::batch
