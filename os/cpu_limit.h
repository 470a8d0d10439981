#pragma once

#include <ctime>

namespace gsim::os {

/// A bound of the processor time that one thread spends, from where this is made on. The clock is the
/// thread's own: what other runs in the process spend does not count, nor what the run waits for (a full
/// disk, a busy machine). To be asked by that thread alone.
class CpuLimit {
  public:
    explicit CpuLimit(double seconds);

    /// Whether the time is used up. Cheap enough for each block of a program: a thread cannot have spent more
    /// than has passed, so its clock, a call of the system, is read only when that might be enough.
    bool reached();
    double seconds() const { return seconds_; }

  private:
    double seconds_;
    double end_s_;                ///< On the thread's clock.
    std::timespec not_before_{};  ///< On the coarse clock: nothing to look at until then.
    bool reached_ = false;
};

}  // namespace gsim::os
