#pragma once

#include "motion/linuxcnc/law.h"
#include "motion/linuxcnc/piece.h"
#include "motion/linuxcnc/ring.h"

namespace gsim::motion::linuxcnc {

/// A piece in the queue with what timing adds to it.
struct HeldPiece {
    Piece piece;
    Law law;
    LimitedBy limited_by;
    bool ends_group = false;  ///< Comes to rest.
    double shared_s = 0;      ///< At its end the next group of pieces moves, too, for so long.
    double written_s = 0;     ///< So much of it has been put out.
    double nearest_mm = 0;    ///< To the corner at its end, while the next group moves, too.
    bool shares_end = false;  ///< nearest_mm has been looked for.

    double left_s() const { return law.duration_s() - written_s; }
};

using PieceQueue = Ring<HeldPiece>;

}  // namespace gsim::motion::linuxcnc
