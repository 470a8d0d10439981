#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>

namespace gsim::studio {

/// Log of rejected requests, in printable lines; of many in a second it has the first ones, and the number of
/// the others.
class RejectionLog {
  public:
    using Sink = std::function<void(const std::string& line)>;
    explicit RejectionLog(Sink sink) : sink_(std::move(sink)) {}

    /// Adds a line; may be called from any thread.
    void add(const std::string& line);

  private:
    using Clock = std::chrono::steady_clock;

    Sink sink_;
    std::mutex mutex_;
    Clock::time_point second_ = Clock::now();
    std::size_t lines_in_second_ = 0;
};

}  // namespace gsim::studio
