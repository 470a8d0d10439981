#pragma once

#include <array>

#include "motion/segment/segment.h"

namespace gsim::cell {

/// How the joints move in a part of a segment, as far as it bounds how far a body can go.
struct JointTravel {
    /// The length of each joint's way, mm or rad; of joints on an arc 0, as `arc_mm` counts for them
    /// together.
    std::array<double, rrs::kMaxJoints> way{};
    /// How far each joint may be from where it were if all went from start to end in proportion.
    std::array<double, rrs::kMaxJoints> bend{};
    std::array<int, 3> arc_joints{-1, -1, -1};  ///< None where there is no arc.
    double arc_mm = 0;
    double arc_bend_mm = 0;  ///< As `bend`, of the point that moves on the arc.

    bool on_arc(int joint) const;
    bool moves() const;
};

/// The travel between two times, in s since the start of the segment. `by_time`: something else moves
/// meanwhile, so that bends are those over time; else they are those over the way of the lead.
JointTravel travel_of(const motion::Segment& segment, double from_s, double to_s, bool by_time = false);

}  // namespace gsim::cell
