#pragma once

#include <vector>

#include "controller/services/types.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// A segment with a superimposed motion keeps its path while it slows down or speeds up. Both motions run
// through their plans at one rate, which is 1 at the planned speed and 0 at standstill. A time law with a
// changing rate is replaced by parts of constant jerk: exact at their ends, off the path by some 1e-6 mm
// between them.

/// Blend at another rate than planned.
struct ScaledBlend {
    std::vector<Segment> parts;  ///< In order, their start_s still to be set.
    double until_s = 0;          ///< End of the last part in the blend's plan.
    double rate = 0;             ///< There.
};

/// Slows down from `from_s` of the blend's plan at `rate` > 0, to standstill or to the blend's end. The
/// joints brake as hard as they can in addition to what the plan takes of their `acceleration` (mm/s2 or
/// rad/s2). A joint that the plan takes beyond that has what the plan takes. A joint that brakes as hard by
/// the plan as it can is not braked harder, so a blend may have to be passed as planned.
ScaledBlend slow_down(const Segment& blend, double from_s, double rate, const rrs::JointPos& acceleration);

/// Speeds up from the start of the blend at `rate`, 0 for standstill, to its end. It reaches the planned
/// rate, or less if the plan takes more than half of the `acceleration`. The other half is for gaining speed.
ScaledBlend speed_up(const Segment& blend, double rate, const rrs::JointPos& acceleration);

/// Returns the part between two instants of the blend's plan, as planned.
Segment blend_part(const Segment& blend, double from_s, double to_s);

/// True if both motions are at standstill at an instant of the blend's plan.
bool is_stationary(const Segment& blend, double at_s);

}  // namespace gsim::motion
