#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"

namespace gsim::batch {

/// A figure of runs, and how much it counts: what is least is best, so that a weight below 0 makes more of it
/// better.
struct Weight {
    std::string figure;  ///< One of kFigures.
    double weight = 1;
};

/// What a figure of each run has to keep.
struct FigureLimit {
    std::string figure;
    std::optional<double> least = {}, most = {};
};

/// What is searched for: the values of a plan's settings for which the sum of the objective over its programs
/// and machines is least, of those with which all runs are without a fault and within the limits.
struct SearchPlan {
    Plan plan;
    std::vector<Weight> objective;
    std::vector<FigureLimit> limits;
    std::uint64_t variants = 200;  ///< That are tried at most.
    std::uint64_t first = 0;       ///< Of these spread evenly at first; 0: as many as the settings need.
    std::uint64_t population = 0;  ///< Variants that are tried at once behind that; 0: likewise.
    std::uint64_t seed = 1;
};

/// Reads a plan with what it says of a search (docs/optimise.md). The error begins with its place.
tl::expected<SearchPlan, std::string> read_search(std::string_view toml_text, const std::string& file_name);

}  // namespace gsim::batch
