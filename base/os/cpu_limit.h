#pragma once

#include <atomic>
#include <ctime>
#include <memory>
#include <utility>

namespace gsim::os {

/// A bound of the processor time that one thread spends, from where this is made on. The clock is the
/// thread's own: what other runs in the process spend does not count, nor what the run waits for (a full
/// disk, a busy machine). To be asked by that thread alone.
class CpuLimit {
  public:
    explicit CpuLimit(double seconds);

    /// It counts as reached as soon as this is true, which any thread may set.
    void end_when(std::shared_ptr<const std::atomic<bool>> asked) { asked_ = std::move(asked); }
    /// Whether that was the reason.
    bool was_asked() const { return asked_ != nullptr && *asked_; }

    /// What a process that works for the thread has spent so far counts, too.
    void count_beside(double seconds) { beside_s_ = seconds; }

    /// Whether the time is used up, or the end was asked for. Cheap enough for each block of a program: a
    /// thread cannot have spent more than has passed, so its clock, a call of the system, is read only when
    /// that might be enough.
    bool reached();
    double seconds() const { return seconds_; }
    /// What is left of them, or less than 0.
    double left_s() const;

  private:
    double seconds_;
    double end_s_;                ///< On the thread's clock.
    std::timespec not_before_{};  ///< On the coarse clock: nothing to look at until then.
    double beside_s_ = 0;
    bool reached_ = false;
    std::shared_ptr<const std::atomic<bool>> asked_ = nullptr;
};

/// A bound of the processor time of the whole process, for work that does not ask: where it is used up, a
/// sentence goes to standard error, temporary files are removed as at any signal that ends the program, and
/// the process ends with `status`. One at a time; from where this is made to where it ends.
class ProcessCpuLimit {
  public:
    /// `sentence`, which must outlive this, ends in a newline.
    ProcessCpuLimit(double seconds, const char* sentence, int status);
    ProcessCpuLimit(const ProcessCpuLimit&) = delete;
    ProcessCpuLimit& operator=(const ProcessCpuLimit&) = delete;
    ~ProcessCpuLimit();

  private:
    timer_t timer_{};
    bool running_ = false;
};

}  // namespace gsim::os
