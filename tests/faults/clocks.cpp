// When preloaded, it makes the clocks jump at each reading: that of the day by a year, back and forth; those
// that count from the start by a minute, forward, as they only run forward. Processor time is unchanged.

#include <atomic>
#include <cstddef>

#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

namespace {

constexpr long kYear_s = 365L * 24 * 3600;
constexpr long kSecondsPerMinute = 60;
constexpr long kNanosecondsOfOne = 1000;

// A preloaded library receives no arguments: its state can only be here.
std::atomic<long> looks = 0;

long jump_s(clockid_t clock) {
    const long look = ++looks;
    const bool counts = clock == CLOCK_MONOTONIC || clock == CLOCK_MONOTONIC_COARSE ||
                        clock == CLOCK_MONOTONIC_RAW || clock == CLOCK_BOOTTIME;
    if (counts) return look * kSecondsPerMinute;
    const bool of_day = clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE;
    if (!of_day) return 0;
    return look % 2 == 0 ? kYear_s : -kYear_s;
}

int jumping(clockid_t clock, timespec* now) {
    const int result = static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
    if (result == 0) now->tv_sec += jump_s(clock);
    return result;
}

}  // namespace

#define GSIM_SHOWN extern "C" [[gnu::visibility("default")]]

GSIM_SHOWN int clock_gettime(clockid_t clock, timespec* now) noexcept {
    return jumping(clock, now);
}

GSIM_SHOWN int gettimeofday(timeval* now, void*) noexcept {
    timespec exact{};
    const int result = jumping(CLOCK_REALTIME, &exact);
    *now = {exact.tv_sec, exact.tv_nsec / kNanosecondsOfOne};
    return result;
}

GSIM_SHOWN time_t time(time_t* now) noexcept {
    timespec exact{};
    jumping(CLOCK_REALTIME, &exact);
    if (now != nullptr) *now = exact.tv_sec;
    return exact.tv_sec;
}
