#pragma once

#include <vector>

#include "analysis/envelope/tcp_chain.h"

namespace gsim::envelope {

/// Line through positions that the TCP reaches.
struct Curve {
    bool closed = false;
    std::vector<Vector3d> points_mm;
};

/// Region that the TCP reaches by two joints, with all others at home.
struct PairOutline {
    int first;  ///< Joints, by their indices.
    int second;
    bool flat;        ///< It lies in a plane: the curves are its border, holes included.
    Vector3d normal;  ///< Plane normal.
    double error_mm;  ///< Max error of the border; holes narrower than twice this are not reported.
    /// If it is no plane: the paths of each joint with the other one at either end of its range. Those that
    /// lie within are omitted, if a joint turns all round.
    std::vector<Curve> curves;
};

/// Returns the outlines of all pairs of joints that both move the TCP.
std::vector<PairOutline> pair_outlines(const TcpChain& chain, const rrs::JointPos& home);

}  // namespace gsim::envelope
