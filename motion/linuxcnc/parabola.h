#pragma once

#include "motion/linuxcnc/piece.h"

namespace gsim::motion::linuxcnc {

/// A parabolic blend: the second piece starts from rest while the first comes to rest, when this is below the
/// speed `before`.
struct Parabola {
    double before = 0;     ///< Speed of the first piece when the second starts.
    double after = 0;      ///< Speed of the second piece when the first is at rest.
    double net_speed = 0;  ///< Of both together on the way round the corner; 0 where neither moves X, Y or Z.
};

/// With these shares of the speeds that the pieces ask for.
Parabola parabola_between(const Piece& before, const Piece& after, double share_before = 1,
                          double share_after = 1);

}  // namespace gsim::motion::linuxcnc
