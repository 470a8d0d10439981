#include "batch/slurm/waiting.h"

#include <thread>

namespace gsim::batch {

tl::expected<ClusterState, std::string> wait_until_over(const std::string& results,
                                                        const std::atomic<bool>& stop,
                                                        std::chrono::milliseconds poll) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::minutes kLongestFault(2);
    auto last_told = Clock::now();
    while (true) {
        auto state = ask_state(results);
        if (state) last_told = Clock::now();
        if (stop || Clock::now() - last_told > kLongestFault || (state && state->is_over())) return state;
        std::this_thread::sleep_for(poll);
    }
}

}  // namespace gsim::batch
