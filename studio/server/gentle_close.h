#pragma once

#include <chrono>
#include <cstddef>

namespace gsim::studio {

/// What is taken in of what is still on its way.
struct ClosingBounds {
    std::size_t bytes = std::size_t{2} << 30U;  ///< More than anybody sends who means it.
    std::chrono::milliseconds time{10'000};
    std::chrono::milliseconds pause{2'000};  ///< Between pieces.
};

/// Ends what is sent on a connection, and takes in what comes until the other end has closed it: closed with
/// bytes unread, it would lose the answer that is on its way. The socket itself stays open.
void end_gently(int socket, const ClosingBounds& bounds = {});

}  // namespace gsim::studio
