#pragma once

#include "motion/lookahead/blocks_before.h"

namespace gsim::motion {

// A corner that is passed exactly makes the speed of a joint jump by what the joint stands. Many small ones
// close together, as of a polygon that stands for a curve, would add up to any acceleration. So what the
// corners of a stretch of the way change together may be one such jump, or what the centripetal share of the
// joint's acceleration makes in the time of that stretch, whichever is more: n corners in a row count for n /
// (n - 1) of the way from the first to the last. A polygon of many sides is then passed at the speed of its
// arc.

struct WindowSpeed {
    double speed = 0;
    bool steps_cover = false;  ///< At that speed the joints' steps cover all corners: none of the stretches
                               ///< needs their accelerations.
};

/// The speed at which the corner between the last block of `before` and `to` may be passed, at most `most`,
/// by what the corners in front of it there have turned already.
WindowSpeed speed_in_window(const PlannerSetup& setup, const BlocksBefore& before, double most,
                            const Block& to);

/// Takes from the accelerations of `to` along its way what the corners in front of it, the one at its entry
/// among them, take of the joints' at its entry_cap.
void leave_for_corners(const PlannerSetup& setup, const BlocksBefore& before, Block& to);

}  // namespace gsim::motion
