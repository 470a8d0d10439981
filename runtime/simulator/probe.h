#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "runtime/simulator/commands.h"

namespace gsim::simulation {

/// Configuration of what the probes of a run touch.
struct ProbeSurface {
    enum class Kind : std::uint8_t {
        environment,  ///< The cell or, without a cell, the targets of the moves.
        none,
        plane,
    };
    Kind kind = Kind::environment;
    std::size_t axis = 0;  ///< Along which the plane lies at at_mm: 0 x, 1 y, 2 z.
    double at_mm = 0;      ///< Machine coordinates of the tool's end, as those of zones.
};

/// Straight feed move that a signal ends.
struct ProbeMove {
    /// Result of a script for the signal.
    enum class ProbeResponse : std::uint8_t { unspecified, never, at_fraction };

    LineMove line;
    bool away = false;  ///< The signal is that contact is lost, else that it is made.
    ProbeResponse response = ProbeResponse::unspecified;
    double fraction = 0;  ///< With at_fraction: share of the path to the target, 0 to 1.
};

/// Result of a probing move.
struct ProbeResult {
    bool found = false;
    bool at_start = false;  ///< The contact was as wanted before the move, so the move is not made.
    /// Axis values at the signal or, without a signal, at the end of the move. The machine stops a little
    /// later, because it has to brake.
    AxisVector at;
};

}  // namespace gsim::simulation
