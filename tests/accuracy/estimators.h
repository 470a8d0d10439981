#pragma once

#include <span>

#include "tests/accuracy/programmed_move.h"

namespace gsim::accuracy {

// Estimates of cycle times by rules of others, s, for a comparison with a plan. Dwells count in all.

/// Returns length over feed, with rapids and feeds at the limits of the axes: the time that a CAM system
/// shows next to its paths.
double length_over_feed_s(std::span<const ProgrammedMove> moves);

/// CAMotics (src/gcode/Move.cpp): the length of all axes over the feed, rapids at 10,000 mm/min, no limits.
double camotics_s(std::span<const ProgrammedMove> moves);

/// Returns the time of the estimator that was proposed to LinuxCNC (pull request #4554 of 2026-09, by its
/// description). It plans trapezoids over a look-ahead of 32 moves. The speed at a joint of two moves is the
/// lower of both peak speeds times the cosine of the turn, at least 0. The speed of arcs is at most
/// sqrt(0.866 a r).
double linuxcnc_parse_s(std::span<const ProgrammedMove> moves);

}  // namespace gsim::accuracy
