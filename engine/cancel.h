#pragma once

#include <atomic>
#include <memory>

namespace gsim::engine {

/// A request to cancel work from anywhere: another thread, a signal, a callback of the work itself. Copies
/// share one state.
class Cancel {
  public:
    void now() { *cancel_flag_ = true; }
    bool is_requested() const { return *cancel_flag_; }

    /// For internal use.
    std::shared_ptr<const std::atomic<bool>> flag() const { return cancel_flag_; }

  private:
    std::shared_ptr<std::atomic<bool>> cancel_flag_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace gsim::engine
