#pragma once

#include <cstddef>
#include <deque>

#include "motion/klipper/queued_move.h"

namespace gsim::motion::klipper {

/// Plans the speeds of a queue that comes to rest at its end; answers how many of its first moves have speeds
/// that no further move can change. `top_before` is the squared cruising speed of the move before the first.
///
/// Two plans go back from the end, each at the junctions as fast as these and the plan's acceleration allow.
/// Where the one with less acceleration turns from speeding up to slowing down it has a peak, and the moves
/// of that rise and fall go no faster than the peak. They change speed as hard as they can, so that between
/// their ramps they cruise.
std::size_t plan_speeds(std::deque<QueuedMove>& queue, double top_before);

}  // namespace gsim::motion::klipper
