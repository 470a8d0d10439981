#pragma once

#include "runtime/motion/block.h"

namespace gsim::motion {

/// The speed at which the corner between two blocks may be passed, and why no faster.
struct CornerSpeed {
    double speed = 0;
    LimitKind limit = LimitKind::stop;
};

/// By the rules of the controller, for the mode in which the first block was programmed. Never above what
/// either block may do. 0 where the measures of the two ways differ (mm of the tool, rad of rotary joints).
CornerSpeed corner_speed(const PlannerSetup& setup, const Block& from, const Block& to);

}  // namespace gsim::motion
