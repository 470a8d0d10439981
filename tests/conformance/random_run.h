#pragma once

#include <cstddef>
#include <string>

#include "base/error.h"
#include "tests/conformance/programs.h"

namespace gsim::conformance {

/// Random programs for both sides.
struct RandomRun {
    std::size_t count = 0;       ///< Programs; 0: none are run.
    std::size_t first_seed = 1;  ///< Seed of the first; each has the next.
    std::string reference = "rs274";
    std::string keep_folder;  ///< Programs that do not agree are written there; empty: nowhere.
};

/// Number of programs by result.
struct RandomTally {
    std::size_t agree = 0;     ///< Both ran to the end, move by move the same.
    std::size_t rejected = 0;  ///< Both refuse.
    std::size_t differ = 0;
};

/// Runs random programs with gsim and with the reference, prints each that differs with its seed, and counts.
/// The error says that the reference is not there.
Result<RandomTally> compare_random(const RandomRun& run, const GsimOptions& gsim);

}  // namespace gsim::conformance
