#pragma once

#include <vector>

#include "motion/segment/segment.h"

namespace gsim::motion {

// Stops during a motion. Each law brakes by itself, as hard as its limits allow: the leading law along its
// path, followers with it. Two simultaneous motions (Segment::superimposed) keep the path that they make
// together (scaled_blend.h). No motion leaves its path, turns back, or is faster than was planned.

/// Motion that is cut by a stop. Segments follow on one another; those without duration are left out.
struct StoppedMotion {
    std::vector<Segment> done;       ///< Up to the instant of the stop: one segment or none.
    std::vector<Segment> braking;    ///< From there until standstill.
    std::vector<Segment> remainder;  ///< Remaining plan after that; only its paths and limits count.
    rrs::JointPos position;          ///< Position at standstill.
};

/// Stops `planned` at `at_s` on the clock. The segments, at least one, are the remainder of a plan that ends
/// at standstill, in the order of time. The first one is active or about to begin. Braking continues in the
/// next segment if one is too short to stop in. `acceleration` is what the joints have for blends (mm/s2 or
/// rad/s2).
StoppedMotion stop_motion(std::vector<Segment> planned, double at_s, const rrs::JointPos& acceleration);

/// Returns the first `t_s` of a segment, as planned. It does not reach the segment's target.
Segment segment_until(const Segment& segment, double t_s);

/// Plans the remainder of a stopped motion again, from standstill. No speed is above the planned one. Each
/// segment ends with the planned speed or with the highest one that it can reach. Their start_s must still be
/// set.
std::vector<Segment> restart_motion(std::vector<Segment> remainder, const rrs::JointPos& acceleration);

}  // namespace gsim::motion
