#pragma once

#include "motion/linuxcnc/law.h"
#include "motion/linuxcnc/piece.h"
#include "motion/linuxcnc/ring.h"

namespace gsim::motion::linuxcnc {

/// Queued sub-segment with its timing data.
struct HeldPiece {
    Piece piece;
    Law law;
    LimitedBy limited_by;
    bool ends_group = false;  ///< True if it stops.
    double shared_s = 0;      ///< Time at its end in which the next group also moves.
    double written_s = 0;     ///< Time of it that has been output.
    double nearest_mm = 0;    ///< To the corner at its end, while the next group moves, too.
    bool shares_end = false;  ///< nearest_mm has been looked for.

    double left_s() const { return law.duration_s() - written_s; }
};

using PieceQueue = Ring<HeldPiece>;

}  // namespace gsim::motion::linuxcnc
