#include "batch/slurm/cluster_wait.h"

#include <thread>

namespace gsim::batch {

Result<ClusterState> wait_until_ended(const std::string& results, const std::atomic<bool>& stop,
                                      std::chrono::milliseconds poll) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::minutes kMaxOutage(2);
    auto last_response = Clock::now();
    while (true) {
        auto state = query_state(results);
        if (state) last_response = Clock::now();
        if (stop || Clock::now() - last_response > kMaxOutage || (state && state->has_ended())) return state;
        std::this_thread::sleep_for(poll);
    }
}

}  // namespace gsim::batch
