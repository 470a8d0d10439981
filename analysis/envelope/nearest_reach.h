#pragma once

#include <vector>

#include "analysis/envelope/tip_chain.h"

namespace gsim::envelope {

/// A place that the tip reaches near `target`: from joint values that bring it close, by damped least squares
/// within the joints' ranges. No farther from the target than where it starts.
Vector3d nearest_reach(const TipChain& chain, const std::vector<double>& from, const Vector3d& target);

}  // namespace gsim::envelope
