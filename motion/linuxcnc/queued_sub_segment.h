#pragma once

#include "motion/linuxcnc/law.h"
#include "motion/linuxcnc/ring_buffer.h"
#include "motion/linuxcnc/sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Queued sub-segment with its timing data.
struct QueuedSubSegment {
    SubSegment sub_segment;
    Law law;
    LimitCause limited_by;
    bool is_group_end = false;      ///< True if it stops.
    double overlap_time_s = 0;      ///< Time at its end in which the next group also moves.
    double emitted_s = 0;           ///< Time of it that has been output.
    double nearest_mm = 0;          ///< To the corner at its end, while the next group moves, too.
    bool is_nearest_known = false;  ///< nearest_mm has been looked for.

    double remaining_s() const { return law.duration_s() - emitted_s; }
};

using SubSegmentQueue = RingBuffer<QueuedSubSegment>;

}  // namespace gsim::motion::linuxcnc
