#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "runtime/simulator/commands.h"

namespace gsim::simulation {

/// What the probes of a run feel.
struct ProbeFeels {
    enum class Kind : std::uint8_t {
        surroundings,  ///< The cell, or where there is none, the targets of the moves.
        nothing,
        plane,
    };
    Kind kind = Kind::surroundings;
    std::size_t axis = 0;  ///< Along which the plane lies at at_mm: 0 x, 1 y, 2 z.
    double at_mm = 0;      ///< Machine coordinates of the tool's end, as those of zones.
};

/// A straight feed move that a signal ends.
struct ProbeMove {
    /// What a script says of the signal.
    enum class Answer : std::uint8_t { none_given, never, at_part };

    LineMove line;
    bool away = false;  ///< The signal is that contact is lost, else that it is made.
    Answer answer = Answer::none_given;
    double part = 0;  ///< With at_part: of the way to the target, 0 to 1.
};

/// What came of one.
struct ProbeResult {
    bool found = false;
    bool at_start = false;  ///< The contact was as wanted before the move, which is none then.
    /// Axis values where the signal came, or without one where the move ended; the machine stands a little
    /// behind, as it has to brake.
    AxisVector at;
};

}  // namespace gsim::simulation
