#pragma once

#include "motion/lookahead/preceding_blocks.h"

namespace gsim::motion {

// A corner that is passed exactly makes the speed of a joint jump by what the joint tolerates. Many small
// corners close together, as of a polygon that approximates a curve, would add up to any acceleration. So the
// total change of the corners of a stretch of the path is limited. It may be one such jump, or what the
// centripetal share of the joint's acceleration gives in the time of that stretch, whichever is more. n
// corners in a row count for n / (n - 1) of the distance from the first to the last. A polygon of many sides
// is then passed at the speed of its arc.

struct WindowSpeed {
    double speed = 0;
    bool is_within_speed_steps = false;  ///< True if the joint steps cover all corners at that speed: no
                                         ///< stretch needs the joint accelerations.
};

/// Returns the speed at which the corner between the last block of `before` and `to` may be passed, at most
/// `speed_cap`, given what the corners before it have already turned.
WindowSpeed speed_in_window(const PlannerSetup& setup, const PrecedingBlocks& before, double speed_cap,
                            const Block& to);

/// Reduces the accelerations of `to` along its path by what the corners before it, including the one at its
/// entry, use of the joints' at its entry_cap.
void reserve_for_corners(const PlannerSetup& setup, const PrecedingBlocks& before, Block& to);

}  // namespace gsim::motion
