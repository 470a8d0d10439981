#pragma once

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/piece.h"
#include "motion/segment/segment.h"

namespace gsim::motion::linuxcnc {

/// A part of a piece's way that is one line or one arc.
struct WayPart {
    bool curved = false;
    rrs::JointPos start;
    rrs::JointPos end;
    Arc arc;
    double length_mm = 0;  ///< 0 where rotary joints alone move.
    double scale = 1;      ///< Length of the path over the length by which the piece is timed.
};

/// The part between two lengths, both on the lead-in or both behind it.
WayPart way_part(const Piece& piece, const Axes& axes, double from, double to);

/// The joints after a length of way.
rrs::JointPos joints_at(const Piece& piece, const Axes& axes, double length);

}  // namespace gsim::motion::linuxcnc
