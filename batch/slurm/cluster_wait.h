#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "base/error.h"
#include "batch/slurm/cluster_batch.h"

namespace gsim::batch {

/// Waits until no job of these results' batch is in the queue, or until `stop`; checks at each interval
/// `poll`. A controller may be unavailable for a while. Returns the final state, or the reason why it is
/// unknown.
Result<ClusterState> wait_until_ended(const std::string& results, const std::atomic<bool>& stop,
                                      std::chrono::milliseconds poll);

}  // namespace gsim::batch
