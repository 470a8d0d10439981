#pragma once

#include "motion/lookahead/blocks_before.h"

namespace gsim::motion {

/// The speed at which the corner between two blocks may be passed, why no faster, and whether it is rounded.
struct CornerSpeed {
    double speed = 0;
    LimitKind limit = LimitKind::stop;
    Blend blend = {};
    bool takes_acceleration = false;  ///< It is passed exactly, by a jump of the joints' speeds, and may with
                                      ///< the corners in front of it take of their accelerations.
};

/// By the rules of the controller, for the mode in which the last block of `before` was programmed, of the
/// corner between it and `to`. Never above what
/// either block may do. 0 where the measures of the two ways differ (mm of the tool, rad of rotary joints).
/// Blends round corners between lines; at the others the rule of exact paths holds, or they stop.
CornerSpeed corner_speed(const PlannerSetup& setup, const BlocksBefore& before, const Block& to);

/// The jump of speed that a joint stands at a corner, mm/s or rad/s.
double speed_step(const PlannerSetup& setup, int joint);

/// What the corner at the end of a block may yet cut off, whatever follows.
double largest_exit_cut(const PlannerSetup& setup, const Block& block);

}  // namespace gsim::motion
