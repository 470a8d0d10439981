#pragma once

#include <vector>

#include "motion/segment/segment.h"

namespace gsim::motion {

// How one joint goes along a segment: where it turns back, and when it passes a value. Told for joints that
// carry position or follow, not for those that turn the tool along an OrientationArc. Times are in seconds
// since the start of the segment.

/// Bounds of the joint's way that are found quickly; they may be too wide.
Range wide_range(const Segment& segment, int joint);

/// Adds instants to `times_s`, in no order: between two of them that are neighbours, or between one and an
/// end of the segment, the joint goes one way, but for less than 1e-10 mm.
void add_turns(const Segment& segment, int joint, std::vector<double>& times_s);

/// When the joint passes `value` between two instants, at which it stands on different sides of it; it goes
/// one way in between. Exact but for rounding: it is a root, not a sample.
double passing_s(const Segment& segment, int joint, double value, double from_s, double to_s);

}  // namespace gsim::motion
