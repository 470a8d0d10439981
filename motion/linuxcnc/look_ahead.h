#pragma once

#include <cstddef>
#include <optional>

#include "motion/linuxcnc/held_piece.h"

namespace gsim::motion::linuxcnc {

/// The part of the queue that a junction's speed depends on.
struct Horizon {
    /// The piece that ends the tangent run in which the junction lies, if it is known.
    std::optional<std::size_t> run_end;
    bool run_end_is_last = false;  ///< Nothing follows in the queue.
    std::size_t depth = 1;         ///< Junctions that are looked at.
};

/// The speed at the tangent end of piece `index`, from which what follows can come to rest. Where the look
/// stops within a run, the last piece seen is one that might have to stop by half.
struct JunctionSpeed {
    double speed = 0;
    LimitKind limit = LimitKind::corner;  ///< corner, stop or look_ahead
};
JunctionSpeed junction_speed(const PieceQueue& queue, std::size_t index, const Horizon& horizon);

/// The same with S-curves: a junction is passed without acceleration, and at no more than the highest speed
/// that either of its pieces has from rest to rest.
JunctionSpeed curved_junction_speed(const PieceQueue& queue, std::size_t index, const Horizon& horizon);

}  // namespace gsim::motion::linuxcnc
