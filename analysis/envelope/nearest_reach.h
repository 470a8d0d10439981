#pragma once

#include <vector>

#include "analysis/envelope/tcp_chain.h"

namespace gsim::envelope {

/// Returns a position near `target` that the TCP reaches: from joint values that bring it close, by damped
/// least squares within the joints' ranges. It is no farther from the target than the start.
Vector3d nearest_reachable_point(const TcpChain& chain, const std::vector<double>& from,
                                 const Vector3d& target);

}  // namespace gsim::envelope
