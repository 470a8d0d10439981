#pragma once

#include <vector>

#include "controller/services/types.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// A segment with a motion beside it keeps its way while it slows down or speeds up: both motions run through
// their plans at one rate, which is 1 at the planned pace and 0 at rest. Where the rate changes, a law of
// time is met by pieces of constant jerk: exact at their ends, off the way by some 1e-6 mm between them.

/// A blend at another pace than planned.
struct BlendPace {
    std::vector<Segment> parts;  ///< In order, their start_s yet to be told.
    double until_s = 0;          ///< Where the last part ends in the blend's plan.
    double rate = 0;             ///< There.
};

/// From `from_s` of the blend's plan at `rate` > 0, slowing down as hard as the joints can beside what the
/// plan takes of their `acceleration` (mm/s2 or rad/s2), to rest or to the blend's end. A joint that the plan
/// takes beyond that has what the plan takes. A joint that brakes as hard by the plan as it can is not braked
/// harder, so that a blend may have to be passed as planned.
BlendPace slow_down(const Segment& blend, double from_s, double rate, const rrs::JointPos& acceleration);

/// From the start of the blend at `rate`, 0 for rest, speeding up to its end: to the planned pace, or less
/// where the plan takes more than half of the `acceleration`, of which the other half is for gaining speed.
BlendPace speed_up(const Segment& blend, double rate, const rrs::JointPos& acceleration);

/// What lies between two instants of the blend's plan, as planned.
Segment blend_part(const Segment& blend, double from_s, double to_s);

/// Whether both motions stand at an instant of the blend's plan.
bool stands(const Segment& blend, double at_s);

}  // namespace gsim::motion
