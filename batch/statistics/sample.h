#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gsim::batch {

/// Interval with a probability of 95 % for a quantity that the sample estimates; an end that the sample
/// cannot determine is missing.
struct Interval {
    std::optional<double> min = {}, max = {};

    bool contains(double value) const { return (!min || *min <= value) && (!max || value <= *max); }
};

struct Percentile {
    double share = 0;  ///< Share of values that lie below: 0.95.
    double value = 0;
    Interval interval = {};
};

/// Statistics of a sample.
struct SampleSummary {
    std::size_t count = 0;
    double mean = 0;
    Interval mean_interval = {};  ///< Student's t.
    double deviation = 0;         ///< For single values (n - 1).
    double min = 0, max = 0;
    std::vector<Percentile> percentiles = {};  ///< 1, 5, 25, 50, 75, 95, 99 %.
    /// Runs needed to know the mean to 1 %; 0 if the mean is 0.
    std::uint64_t runs_for_percent = 0;
};

/// Summarises at least one value, in any order. Percentiles are between order statistics (Hyndman and Fan
/// 1996, type 7). Their intervals are order statistics themselves, for any distribution (David and Nagaraja
/// 2003, 7.1). They hold with at least 95 % for independent samples, and more often for even designs (Latin
/// hypercube, Sobol).
SampleSummary summarize(std::vector<double> values);

/// Returns the interval of the share that has a property, from `hits` of `count`: Clopper and Pearson 1934.
Interval proportion_interval(std::uint64_t hits, std::uint64_t count);

struct Bin {
    double from = 0, to = 0;
    std::uint64_t count = 0;
};
/// Returns equal bins with the width of Freedman and Diaconis 1981, 60 at most.
std::vector<Bin> histogram(std::vector<double> values);

/// Distance of the mean of the first values from that of all, and half of its interval, at counts that
/// double.
struct Convergence {
    std::size_t count = 0;
    double mean = 0;
    double half_width = 0;
};
std::vector<Convergence> convergence(std::span<const double> values);

}  // namespace gsim::batch
