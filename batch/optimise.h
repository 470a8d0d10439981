#pragma once

#include <string>
#include <vector>

namespace gsim::batch {

inline constexpr const char* kOptimise = "gsim-optimise";

/// What this program does under that name: looks for the best values of a plan's settings. The exit status.
int optimise(const std::vector<std::string>& words);

}  // namespace gsim::batch
