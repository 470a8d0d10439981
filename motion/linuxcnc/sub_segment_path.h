#pragma once

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/sub_segment.h"
#include "motion/segment/segment.h"

namespace gsim::motion::linuxcnc {

/// Part of a sub-segment's path that is one line or one arc.
struct PathPart {
    bool curved = false;
    rrs::JointPos start;
    rrs::JointPos end;
    Arc arc;
    double length_mm = 0;  ///< 0 if only rotary joints move.
    double scale = 1;      ///< Path length divided by the length that is used for timing.
};

/// Returns the part between two lengths, both on the lead-in or both past it.
PathPart path_part(const SubSegment& sub_segment, const Axes& axes, double from, double to);

/// Returns the joints at a path length.
rrs::JointPos joints_at(const SubSegment& sub_segment, const Axes& axes, double length);

}  // namespace gsim::motion::linuxcnc
