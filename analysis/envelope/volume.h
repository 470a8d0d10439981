#pragma once

#include <string>

#include "analysis/envelope/surface.h"
#include "base/error.h"

namespace gsim::envelope {

/// Volume that the TCP of a machine reaches in the work frame.
struct Volume {
    Surface surface;     ///< Closed. Its corners are positions that the TCP reaches.
    double step_mm = 0;  ///< Step of the grid that it was found on; 0 if it is exact.
    /// Max distance of a reachable position outside the surface, and of a position within from a reachable
    /// one. Holes narrower than twice this are not reported.
    double error_mm = 0;
};

/// Returns the volume of a chain on grids of `nodes` in their longest direction; with 80 it takes some
/// seconds and 50 MB. A machine of three slides has its exact box.
Volume reached_volume(const TcpChain& chain, int nodes = 80);

/// Returns the chain of a machine for its envelope. The error is a message: no joint moves the TCP, or one of
/// them has no end.
Result<TcpChain> envelope_chain(const machine::Machine& machine);

}  // namespace gsim::envelope
