#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include <tl/expected.hpp>

#include "batch/slurm/cluster_batch.h"

namespace gsim::batch {

/// Waits until nothing of the batch of these results is in the queue, or `stop`; looks each `poll`. A
/// controller may be away for a while. The state then, or why it cannot be told.
tl::expected<ClusterState, std::string> wait_until_over(const std::string& results,
                                                        const std::atomic<bool>& stop,
                                                        std::chrono::milliseconds poll);

}  // namespace gsim::batch
