#pragma once

#include <vector>

#include "motion/segment/segment.h"

namespace gsim::motion {

// Motion of one joint along a segment: where it turns back, and when it passes a value. Valid for joints that
// carry position or follow, not for those that turn the tool along an OrientationArc. Times are in seconds
// since the start of the segment.

/// Returns bounds of the joint's path that are found quickly; they may be too wide.
Range range_bounds(const Segment& segment, int joint);

/// Adds instants to `times_s`, in no order. The joint moves in one direction between two neighbouring
/// instants, or between one and an end of the segment, except for less than 1e-10 mm.
void add_reversal_times(const Segment& segment, int joint, std::vector<double>& times_s);

/// Returns the time at which the joint passes `value` between two instants. The joint is on different sides
/// of it at these, and moves in one direction in between. The result is exact except for rounding: it is a
/// root, not a sample.
double crossing_time_s(const Segment& segment, int joint, double value, double from_s, double to_s);

}  // namespace gsim::motion
