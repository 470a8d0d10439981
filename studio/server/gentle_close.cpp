#include "studio/server/gentle_close.h"

#include <algorithm>
#include <array>

#include <poll.h>
#include <sys/socket.h>

namespace gsim::studio {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kTakenIn = std::size_t{64} << 10U;

}  // namespace

void end_gently(int socket, const ClosingBounds& bounds) {
    ::shutdown(socket, SHUT_WR);
    std::array<char, kTakenIn> bytes{};
    const auto end = Clock::now() + bounds.time;
    for (std::size_t taken = 0; taken < bounds.bytes;) {
        const auto left =
            std::min(std::chrono::duration_cast<milliseconds>(end - Clock::now()), bounds.pause);
        pollfd asked{socket, POLLIN, 0};
        if (left.count() <= 0 || ::poll(&asked, 1, static_cast<int>(left.count())) <= 0) return;
        const ssize_t got = ::recv(socket, bytes.data(), bytes.size(), 0);
        if (got <= 0) return;
        taken += static_cast<std::size_t>(got);
    }
}

}  // namespace gsim::studio
