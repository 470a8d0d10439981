#pragma once

#include <cstddef>
#include <deque>

#include "motion/klipper/queued_move.h"

namespace gsim::motion::klipper {

/// Plans the speeds of a queue that stops at its end. Returns how many of its first moves have speeds that no
/// further move can change. `last_cruise_squared` is the squared cruising speed of the move before the first.
///
/// Two plans run backward from the end. Each is as fast at the junctions as these and the plan's acceleration
/// allow. The one with less acceleration has a peak at each change from speeding up to slowing down. The
/// moves of that rise and fall are no faster than the peak. They change speed as hard as they can, so that
/// they cruise between their ramps.
std::size_t plan_speeds(std::deque<QueuedMove>& queue, double last_cruise_squared);

}  // namespace gsim::motion::klipper
