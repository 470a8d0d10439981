#pragma once

#include <array>

#include "motion/segment/segment.h"

namespace gsim::cell {

/// Motion of the joints in a part of a segment, as far as it bounds the travel of a body.
struct JointTravel {
    /// Path length of each joint, mm or rad; 0 for joints on an arc, because `arc_mm` counts for them
    /// together.
    std::array<double, rrs::kMaxJoints> distance{};
    /// Max deviation of each joint from a motion of all in proportion from start to end.
    std::array<double, rrs::kMaxJoints> deviation{};
    std::array<int, 3> arc_joints{-1, -1, -1};  ///< -1 without an arc.
    double arc_mm = 0;
    double arc_deviation_mm = 0;  ///< As `deviation`, of the point that moves on the arc.

    bool is_on_arc(int joint) const;
    bool moves() const;
};

/// Returns the travel between two times, in s since the start of the segment. `over_time`: something else
/// moves meanwhile, so deviations are over time; otherwise they are over the distance of the leading law.
JointTravel joint_travel(const motion::Segment& segment, double from_s, double to_s, bool over_time = false);

}  // namespace gsim::cell
