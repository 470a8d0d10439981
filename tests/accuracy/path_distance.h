#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "tests/accuracy/blocks.h"
#include "tests/accuracy/trajectory.h"

namespace gsim::accuracy {

/// Max permitted distance between positions, in mm.
inline constexpr double kGoodDistance_mm = 1.0;

/// Run of a program that stops after each block.
struct TimedPath {
    Trajectory trajectory;  ///< Not empty.
    std::vector<Block> blocks;
};

/// Position at which two runs of a program are farthest from each other.
struct Distance {
    double mm = 0;
    long line = 0;
    double into_block_s = 0;  ///< Since the start of the block.
};

/// Returns the largest distance of X, Y and Z at equal times since the start of each block, at the samples of
/// `recorded`. A block of `found` that ends earlier stays at its end. The error names the first block that
/// the runs do not share, or says that no data can be compared.
Result<Distance> largest_distance(const TimedPath& recorded, const TimedPath& found);

}  // namespace gsim::accuracy
