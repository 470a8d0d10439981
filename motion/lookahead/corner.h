#pragma once

#include "motion/lookahead/preceding_blocks.h"

namespace gsim::motion {

/// Speed at which the corner between two blocks may be passed, the reason for this limit, and its rounding.
struct CornerSpeed {
    double speed = 0;
    LimitKind limit = LimitKind::stop;
    Blend blend = {};
    bool uses_acceleration = false;  ///< True if it is passed exactly, by a jump of the joint speeds, and
                                     ///< may, with the corners before it, use joint accelerations.
};

/// Returns the speed of the corner between `before` and `to`, by the controller's rules for the mode in which
/// the last block of `before` was programmed. It is never above what either block may do. It is 0 if the
/// measures of the two paths differ (mm of the tool, rad of rotary joints). Blends round corners between
/// lines; the others follow the rule of exact paths, or stop.
CornerSpeed corner_speed(const PlannerSetup& setup, const PrecedingBlocks& before, const Block& to);

/// Returns the jump of speed that a joint tolerates at a corner, mm/s or rad/s.
double speed_step(const PlannerSetup& setup, int joint);

/// Returns the largest length that the corner at the end of a block may still cut off, for any next block.
double largest_exit_cut(const PlannerSetup& setup, const Block& block);

}  // namespace gsim::motion
