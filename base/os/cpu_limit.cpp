#include "base/os/cpu_limit.h"

#include <algorithm>
#include <cmath>
#include <csignal>

#include "base/os/temporary_name.h"

namespace gsim::os {

namespace {

// Wait that is longer than the coarse clock's step, and short enough to add up without overflow.
constexpr double kLeastWait_s = 0.01;
constexpr double kMostWait_s = 1e6;
constexpr double kNanoseconds = 1e9;

double seconds_of(const std::timespec& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / kNanoseconds;
}

double thread_time_s() {
    std::timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return seconds_of(now);
}

std::timespec later(std::timespec time, double wait_s) {
    const double whole_s = std::floor(wait_s);
    time.tv_sec += static_cast<std::time_t>(whole_s);
    time.tv_nsec += static_cast<long>((wait_s - whole_s) * kNanoseconds);
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
    if (was_asked()) return reached_ = true;
    std::timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
    if (is_before(now, not_before_)) return false;
    const double left_s = this->left_s();
    reached_ = left_s <= 0;
    not_before_ = later(now, std::clamp(left_s, kLeastWait_s, kMostWait_s));
    return reached_;
}

double CpuLimit::left_s() const {
    return end_s_ - thread_time_s() - beside_s_;
}

ProcessCpuLimit::ProcessCpuLimit(double seconds, const char* sentence, int status) {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGXCPU;
    running_ = ::timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer_) == 0;
    if (!running_) return;
    end_at_cpu_signal(sentence, status);
    itimerspec when{};
    when.it_value = later({}, std::clamp(seconds, kLeastWait_s, kMostWait_s));
    ::timer_settime(timer_, 0, &when, nullptr);
}

ProcessCpuLimit::~ProcessCpuLimit() {
    if (!running_) return;
    ::timer_delete(timer_);
    end_at_cpu_signal(nullptr, 0);
}

}  // namespace gsim::os
