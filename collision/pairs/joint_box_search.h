#pragma once

#include <cstdint>
#include <vector>

#include "collision/pairs/meeting_pairs.h"
#include "machine/model/joint_box.h"

namespace gsim::cell {

enum class Verdict : std::uint8_t {
    free,      ///< Proven: the two touch nowhere in the box.
    contact,   ///< They touch where the finding says.
    undecided  ///< Neither was found before the search had to end.
};

/// How near two items come to each other, whatever the joints do.
struct MeetingFinding {
    ItemPair items;
    Verdict verdict;
    double nearest_mm;     ///< The smallest distance that was found; not the least one.
    rrs::JointPos joints;  ///< Where: of contacts that were found the one nearest to home. What does not
                           ///< move the two against each other is at home.
    double contact_share;  ///< Share of the samples in which they touch.
};

/// Looks for contacts between the bodies of a cell over all joint values of a box. Samples (Halton) find
/// most; where they find none, the box is halved again and again, the part with the least lower bound first:
/// no point of a body goes farther between the middle of a part and its ends than ChainMotion::bound(), so a
/// part in whose middle the bodies are farther apart is free, and so is one in which the plane between them
/// is not reached (ways_along_mm()). The jet is not looked at. The same input gives the same findings.
std::vector<MeetingFinding> search_joint_box(const Cell& cell, const machine::Machine& machine,
                                             const machine::JointBox& box);

}  // namespace gsim::cell
