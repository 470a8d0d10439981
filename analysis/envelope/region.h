#pragma once

#include <vector>

#include "analysis/envelope/tip_chain.h"

namespace gsim::envelope {

/// What the tip reaches in a plane.
struct Region {
    /// Its border: the outer one, and one round each hole. Places that the tip reaches.
    std::vector<std::vector<Vector3d>> loops_mm;
    double error_mm;  ///< By how much the border may be off.
};

/// The directions to the right and up in which a plane is shown: up along Z as far as it can be, else along
/// Y.
struct PlaneView {
    Vector3d right;
    Vector3d up;
};
PlaneView plane_view(const Vector3d& normal);

/// The region of two joints that keep the tip in a plane, on a grid in it, as ReachField finds volumes.
Region reached_region(const TipChain& chain, const Vector3d& normal);

}  // namespace gsim::envelope
