#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/outcome.h"

namespace gsim::accuracy {

/// Deviations of the times of many programs, in percent of the recorded times, without sign.
struct Distribution {
    std::size_t count = 0;
    double median_percent = 0;
    double p95_percent = 0;      ///< 95 of 100 are nearer.
    std::size_t within = 0;      ///< Number in Tolerance{0.5, 0.005}.
    double largest_percent = 0;  ///< With sign,
    std::string largest;         ///< and of which program.
};

/// Returns the distribution of counted outcomes with a time; the others count as infinitely far off.
Distribution distribution_of(const std::vector<TimeOutcome>& outcomes);

/// Results of one estimator for one controller's programs.
struct EstimatedController {
    std::string controller;
    std::string estimator;
    Distribution distribution;
};

/// A table of all of them.
std::string distribution_table(const std::vector<EstimatedController>& rows, bool markdown);

}  // namespace gsim::accuracy
