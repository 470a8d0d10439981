#include "studio/server/lingering_close.h"

#include <algorithm>
#include <array>

#include <poll.h>
#include <sys/socket.h>

namespace gsim::studio {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kLingeringBufferSize = std::size_t{64} << 10U;

}  // namespace

void lingering_close(int socket, const CloseLimits& bounds) {
    ::shutdown(socket, SHUT_WR);
    std::array<char, kLingeringBufferSize> bytes{};
    const auto end = Clock::now() + bounds.time;
    for (std::size_t total_bytes = 0; total_bytes < bounds.bytes;) {
        const auto remaining =
            std::min(std::chrono::duration_cast<milliseconds>(end - Clock::now()), bounds.pause);
        pollfd poll_entry{socket, POLLIN, 0};
        if (remaining.count() <= 0 || ::poll(&poll_entry, 1, static_cast<int>(remaining.count())) <= 0)
            return;
        const ssize_t bytes_received = ::recv(socket, bytes.data(), bytes.size(), 0);
        if (bytes_received <= 0) return;
        total_bytes += static_cast<std::size_t>(bytes_received);
    }
}

}  // namespace gsim::studio
