#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>

namespace gsim::studio {

/// Tells what was refused, in lines that can be shown; of many in a second the first ones, and how many more.
class RefusalLog {
  public:
    using Sink = std::function<void(const std::string& line)>;
    explicit RefusalLog(Sink sink) : sink_(std::move(sink)) {}

    /// From any thread.
    void add(const std::string& line);

  private:
    using Clock = std::chrono::steady_clock;

    Sink sink_;
    std::mutex mutex_;
    Clock::time_point second_ = Clock::now();
    std::size_t in_second_ = 0;
};

}  // namespace gsim::studio
