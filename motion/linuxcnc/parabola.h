#pragma once

#include "motion/linuxcnc/sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Parabolic blend: the second sub-segment starts from standstill while the first one stops, after this is
/// below the speed `before`.
struct Parabola {
    double before = 0;     ///< Speed of the first sub-segment when the second starts.
    double after = 0;      ///< Speed of the second sub-segment when the first has stopped.
    double net_speed = 0;  ///< Speed of both together round the corner; 0 if neither moves X, Y or Z.
};

/// Returns the blend with these shares of the requested speeds of the sub-segments.
Parabola parabola_between(const SubSegment& before, const SubSegment& after, double share_before = 1,
                          double share_after = 1);

}  // namespace gsim::motion::linuxcnc
