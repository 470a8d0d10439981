#pragma once

#include <cstddef>
#include <optional>

#include "motion/linuxcnc/queued_sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Part of the queue that determines a junction's speed.
struct Horizon {
    /// Sub-segment that ends the tangent run of the junction, if it is known.
    std::optional<std::size_t> tangent_run_end;
    bool is_queue_end = false;  ///< True if the queue ends there.
    std::size_t depth = 1;      ///< Junctions that are looked at.
};

/// Speed at the tangent end of sub-segment `index`, from which the following ones can stop. The last
/// sub-segment in view counts as one that might have to stop by half, if the search ends within a run.
struct JunctionSpeed {
    double speed = 0;
    LimitKind limit = LimitKind::corner;  ///< corner, stop or look_ahead
};
JunctionSpeed junction_speed(const SubSegmentQueue& queue, std::size_t index, const Horizon& horizon);

/// Returns the same with S-curves: a junction is passed without acceleration, and no faster than the highest
/// speed that either of its sub-segments has from standstill to standstill.
JunctionSpeed curved_junction_speed(const SubSegmentQueue& queue, std::size_t index, const Horizon& horizon);

}  // namespace gsim::motion::linuxcnc
