#pragma once

#include <atomic>
#include <ctime>
#include <memory>
#include <utility>

namespace gsim::os {

/// A limit of the processor time that one thread spends from the creation of this object on. The clock is the
/// thread's own: time of other runs in the process does not count, nor waiting of the run (for a full disk, a
/// busy machine). Only that thread may query it.
class CpuLimit {
  public:
    explicit CpuLimit(double seconds);

    /// Makes the limit count as reached as soon as `stop_flag` is true, which any thread may set.
    void set_cancel_flag(std::shared_ptr<const std::atomic<bool>> stop_flag) {
        cancel_flag_ = std::move(stop_flag);
    }
    /// True if that flag was the reason.
    bool was_cancelled() const { return cancel_flag_ != nullptr && *cancel_flag_; }

    /// Counts also the time that a process working for the thread has spent so far.
    void set_helper_time(double seconds) { helper_time_s_ = seconds; }

    /// True if the time is used up, or the end was requested. Cheap enough for each block of a program: a
    /// thread cannot have spent more than the elapsed time. So its clock, a system call, is read only if that
    /// might be enough.
    bool reached();
    double seconds() const { return seconds_; }
    /// Returns the remaining seconds, or less than 0.
    double remaining_s() const;

  private:
    double seconds_;
    double end_s_;                ///< On the thread's clock.
    std::timespec next_check_{};  ///< On the coarse clock: no check is needed until then.
    double helper_time_s_ = 0;
    bool reached_ = false;
    std::shared_ptr<const std::atomic<bool>> cancel_flag_ = nullptr;
};

/// A limit of the processor time of the full process, for work that does not query it. Once it is used up, a
/// message is written to standard error. Temporary files are removed as at any signal that ends the program,
/// and the process ends with `status`. One at a time, for the lifetime of this object.
class ProcessCpuLimit {
  public:
    /// `message` must outlive this object and end in a newline.
    ProcessCpuLimit(double seconds, const char* message, int status);
    ProcessCpuLimit(const ProcessCpuLimit&) = delete;
    ProcessCpuLimit& operator=(const ProcessCpuLimit&) = delete;
    ~ProcessCpuLimit();

  private:
    timer_t timer_{};
    bool running_ = false;
};

}  // namespace gsim::os
