#include "base/os/cpu_limit.h"

#include <algorithm>
#include <cmath>
#include <csignal>

#include "base/os/temporary_name.h"

namespace gsim::os {

namespace {

// Wait that is longer than the coarse clock's step, and short enough to add up without overflow.
constexpr double kMinWait_s = 0.01;
constexpr double kMaxWait_s = 1e6;
constexpr double kNanoseconds = 1e9;

double path_duration_s(const std::timespec& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / kNanoseconds;
}

double thread_time_s() {
    std::timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return path_duration_s(now);
}

std::timespec add_seconds(std::timespec time, double wait_s) {
    const double whole_seconds = std::floor(wait_s);
    time.tv_sec += static_cast<std::time_t>(whole_seconds);
    time.tv_nsec += static_cast<long>((wait_s - whole_seconds) * kNanoseconds);
    if (static_cast<double>(time.tv_nsec) >= kNanoseconds) {
        time.tv_nsec -= static_cast<long>(kNanoseconds);
        ++time.tv_sec;
    }
    return time;
}

bool is_before(const std::timespec& one, const std::timespec& other) {
    return one.tv_sec != other.tv_sec ? one.tv_sec < other.tv_sec : one.tv_nsec < other.tv_nsec;
}

}  // namespace

CpuLimit::CpuLimit(double seconds) : seconds_(seconds), end_s_(thread_time_s() + seconds) {}

bool CpuLimit::reached() {
    if (reached_) return true;
    if (was_cancelled()) return reached_ = true;
    std::timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
    if (is_before(now, next_check_)) return false;
    const double remaining_s = this->remaining_s();
    reached_ = remaining_s <= 0;
    next_check_ = add_seconds(now, std::clamp(remaining_s, kMinWait_s, kMaxWait_s));
    return reached_;
}

double CpuLimit::remaining_s() const {
    return end_s_ - thread_time_s() - helper_time_s_;
}

ProcessCpuLimit::ProcessCpuLimit(double seconds, const char* message, int status) {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGXCPU;
    running_ = ::timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer_) == 0;
    if (!running_) return;
    exit_at_cpu_signal(message, status);
    itimerspec when{};
    when.it_value = add_seconds({}, std::clamp(seconds, kMinWait_s, kMaxWait_s));
    ::timer_settime(timer_, 0, &when, nullptr);
}

ProcessCpuLimit::~ProcessCpuLimit() {
    if (!running_) return;
    ::timer_delete(timer_);
    exit_at_cpu_signal(nullptr, 0);
}

}  // namespace gsim::os
