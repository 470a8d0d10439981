#pragma once

#include <vector>

#include "analysis/envelope/tip_chain.h"

namespace gsim::envelope {

/// A line through places that the tip reaches.
struct Curve {
    bool closed = false;
    std::vector<Vector3d> points_mm;
};

/// What the tip reaches by two joints, with all others at home.
struct PairOutline {
    int first;  ///< Joints, by their indices.
    int second;
    bool flat;        ///< It lies in a plane: the curves are its border, holes included.
    Vector3d normal;  ///< Of the plane.
    double error_mm;  ///< By how much the border may be off; holes narrower than twice this are not told.
    /// Where it is no plane: the ways of each joint with the other one at either end of its range; none of
    /// those that lie within, where a joint turns all round.
    std::vector<Curve> curves;
};

/// The outlines of all pairs of joints that both move the tip.
std::vector<PairOutline> pair_outlines(const TipChain& chain, const rrs::JointPos& home);

}  // namespace gsim::envelope
