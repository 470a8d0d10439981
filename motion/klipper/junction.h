#pragma once

#include "motion/klipper/queued_move.h"

namespace gsim::motion::klipper {

/// Sets how fast both plans may pass from one move to the other.
void join(const PlannerSetup& setup, const QueuedMove& before, QueuedMove& move);

}  // namespace gsim::motion::klipper
