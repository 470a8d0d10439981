#pragma once

#include <chrono>
#include <thread>

namespace gsim::tests {

/// Returns true if `holds()` is true within a minute, checked each 5 ms. It is for results of other processes
/// and threads, which take their time on a slow machine. Only a test that fails waits so long.
template <typename Condition>
bool soon(const Condition& condition) {
    constexpr std::chrono::seconds kPatience{60};
    constexpr std::chrono::milliseconds kPause{5};
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(kPause);
    }
    return true;
}

}  // namespace gsim::tests
