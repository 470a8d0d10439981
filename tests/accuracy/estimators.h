#pragma once

#include <span>

#include "tests/accuracy/programmed_move.h"

namespace gsim::accuracy {

// Estimates of cycle times by rules of others, s, for a comparison with a plan. Dwells count in all.

/// Length over feed, rapids and feeds at what the axes allow: what a CAM system shows beside its paths.
double length_over_feed_s(std::span<const ProgrammedMove> moves);

/// CAMotics (src/gcode/Move.cpp): the length of all axes over the feed, rapids at 10,000 mm/min, no limits.
double camotics_s(std::span<const ProgrammedMove> moves);

/// The estimator that was proposed to LinuxCNC (pull request #4554 of 2026-09, by its description):
/// trapezoids over a look-ahead of 32 moves; at a joint of two moves the lower of both peak speeds times the
/// cosine of the turn, at least 0; arcs at most at sqrt(0.866 a r).
double linuxcnc_parse_s(std::span<const ProgrammedMove> moves);

}  // namespace gsim::accuracy
