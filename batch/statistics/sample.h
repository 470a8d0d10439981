#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gsim::batch {

/// What holds with a probability of 95 % of what a sample is of; an end that it cannot tell is not there.
struct Interval {
    std::optional<double> least = {}, most = {};

    bool holds(double value) const { return (!least || *least <= value) && (!most || value <= *most); }
};

struct Percentile {
    double share = 0;  ///< Of all values that lie below: 0.95.
    double value = 0;
    Interval interval = {};
};

/// What a sample tells of what it was drawn from.
struct SampleSummary {
    std::size_t count = 0;
    double mean = 0;
    Interval mean_interval = {};  ///< Student's t.
    double deviation = 0;         ///< Of single values (n - 1).
    double least = 0, most = 0;
    std::vector<Percentile> percentiles = {};  ///< 1, 5, 25, 50, 75, 95, 99 %.
    /// How many runs are enough for the mean to be known to 1 %; 0 where it is 0.
    std::uint64_t runs_for_percent = 0;
};

/// Of values in any order, one at least. Percentiles are between order statistics (Hyndman and Fan 1996, type
/// 7); their intervals are order statistics themselves, whatever the distribution (David and Nagaraja
/// 2003, 7.1): of draws that do not depend on each other they hold with 95 % at least, of even designs (Latin
/// hypercube, Sobol) more often.
SampleSummary summarize(std::vector<double> values);

/// The share of what has a property, of which `hits` of `count` had it: Clopper and Pearson 1934.
Interval share_interval(std::uint64_t hits, std::uint64_t count);

struct Bin {
    double from = 0, to = 0;
    std::uint64_t count = 0;
};
/// Equal bins, as wide as Freedman and Diaconis 1981 have them, 60 at most.
std::vector<Bin> histogram(std::vector<double> values);

/// How far the mean of the first values lies from that of all, and the half of its interval, at counts that
/// double.
struct Convergence {
    std::size_t count = 0;
    double mean = 0;
    double half_width = 0;
};
std::vector<Convergence> convergence(std::span<const double> values);

}  // namespace gsim::batch
