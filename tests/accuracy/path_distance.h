#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "tests/accuracy/blocks.h"
#include "tests/accuracy/trajectory.h"

namespace gsim::accuracy {

/// The most that positions may be apart, mm.
inline constexpr double kGoodDistance_mm = 1.0;

/// A run of a program that comes to rest after each block.
struct TimedPath {
    Trajectory trajectory;  ///< Not empty.
    std::vector<Block> blocks;
};

/// Where two runs of a program are farthest from each other.
struct Distance {
    double mm = 0;
    long line = 0;
    double into_block_s = 0;  ///< Since the start of the block.
};

/// The largest distance of X, Y and Z at equal times since the start of each block, at the samples of
/// `recorded`; a block of `found` that ends earlier rests at its end. The error names the first block that
/// the runs do not share, or says that there is nothing to compare.
tl::expected<Distance, std::string> largest_distance(const TimedPath& recorded, const TimedPath& found);

}  // namespace gsim::accuracy
