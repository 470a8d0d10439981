#pragma once

#include <string>

#include <tl/expected.hpp>

#include "analysis/envelope/surface.h"

namespace gsim::envelope {

/// All that the tip of a machine reaches in the work frame.
struct Volume {
    Surface surface;     ///< Closed. Its corners are places that the tip reaches.
    double step_mm = 0;  ///< Of the grid that it was found on; 0 where it is exact.
    /// No reachable place is farther out of the surface, and no place within is farther from a reachable one.
    /// Holes narrower than twice this are not told.
    double error_mm = 0;
};

/// The volume of a chain on grids of `nodes` in their longest direction; with 80 it takes some seconds and 50
/// MB. A machine of three slides has its exact box.
Volume reached_volume(const TipChain& chain, int nodes = 80);

/// The chain of a machine for its envelope. The error is a sentence: no joint moves the tip, or one of them
/// has no end.
tl::expected<TipChain, std::string> envelope_chain(const machine::Machine& machine);

}  // namespace gsim::envelope
