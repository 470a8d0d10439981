#pragma once

#include <chrono>
#include <cstddef>

namespace gsim::studio {

/// Limits for data that are read while a connection is closed.
struct CloseLimits {
    std::size_t bytes = std::size_t{2} << 30U;  ///< More than any legitimate sender sends.
    std::chrono::milliseconds time{10'000};
    std::chrono::milliseconds pause{2'000};  ///< Between parts.
};

/// Ends sending on a connection, and reads data until the other end has closed it. Closing it with unread
/// bytes would lose the response that is being sent. The socket itself stays open.
void lingering_close(int socket, const CloseLimits& bounds = {});

}  // namespace gsim::studio
