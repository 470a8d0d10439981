#pragma once

#include <string>
#include <vector>

namespace gsim::batch {

inline constexpr const char* kOptimiseName = "gsim-optimise";

/// Implements gsim-optimise: searches for the best values of a plan's settings. Returns the exit status.
int optimise(const std::vector<std::string>& words);

}  // namespace gsim::batch
