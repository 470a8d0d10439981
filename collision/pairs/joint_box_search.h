#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/candidate_pairs.h"
#include "machine/model/joint_box.h"

namespace gsim::cell {

enum class Verdict : std::uint8_t {
    free,      ///< Proven: the two touch nowhere in the box.
    contact,   ///< They touch at the pose of the finding.
    undecided  ///< No result before the search had to end.
};

/// Distance of two items over all joint values.
struct PairFinding {
    ItemPair items;
    Verdict verdict;
    double nearest_mm;     ///< Smallest distance that was found, not the true minimum.
    rrs::JointPos joints;  ///< Values there; of several contacts, the one nearest to home. Joints that do not
                           ///< move the two relatively are at home.
    double contact_share;  ///< Share of the samples in which they touch.
};

/// Searches for contacts between the bodies of a cell over all joint values of a box. Samples (Halton) find
/// most. If they find none, the box is halved again and again, the part with the smallest lower bound first.
/// Between the middle of a part and its ends no point of a body moves farther than ChainMotion::bound(). So a
/// part is free if its bodies are farther from each other at its middle, or if the plane between them is not
/// reached (travels_along_mm()). The jet is not checked. The same input gives the same findings.
std::vector<PairFinding> search_joint_box(const Cell& cell, const machine::Machine& machine,
                                          const machine::JointBox& box);

}  // namespace gsim::cell
