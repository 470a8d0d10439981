#pragma once

#include <vector>

#include "analysis/envelope/tcp_chain.h"

namespace gsim::envelope {

/// Reach of the TCP in a plane.
struct Region {
    /// Its borders, through positions that the TCP reaches: the outer one, and one round each hole.
    std::vector<std::vector<Vector3d>> loops_mm;
    double error_mm;  ///< By how much the border may be off.
};

/// Directions to the right and up in which a plane is shown: up along Z as far as possible, otherwise along
/// Y.
struct PlaneView {
    Vector3d right;
    Vector3d up;
};
PlaneView plane_view(const Vector3d& normal);

/// Returns the region of two joints that keep the TCP in a plane, on a grid in it, as ReachField finds
/// volumes.
Region reached_region(const TcpChain& chain, const Vector3d& normal);

}  // namespace gsim::envelope
