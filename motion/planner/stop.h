#pragma once

#include <vector>

#include "motion/segment/segment.h"

namespace gsim::motion {

// Stopping in the midst of a motion. Each law brakes by itself, as hard as its limits allow: the lead along
// its path, followers beside it. Two motions that go on at once (Segment::beside) keep the way that they make
// together (blend_pace.h). Nothing leaves its path, turns back, or goes faster than was planned.

/// A motion that is cut by a stop. Segments follow on one another; those without duration are left out.
struct StoppedMotion {
    std::vector<Segment> done;     ///< Up to the instant of the stop: one segment or none.
    std::vector<Segment> braking;  ///< From there until it stands.
    std::vector<Segment> rest;     ///< What was planned behind that; only its ways and limits count.
    rrs::JointPos position;        ///< Where it stands.
};

/// Stops `planned` at `at_s` on the clock. The segments, at least one, are the rest of a plan that ends at
/// rest, in the order of time; the first one is under way or about to begin. Where a segment is too short to
/// stop in, braking goes on in the next one. `acceleration` is what the joints have for blends (mm/s2 or
/// rad/s2).
StoppedMotion stop_motion(std::vector<Segment> planned, double at_s, const rrs::JointPos& acceleration);

/// The first `t_s` of a segment, as planned. It does not reach the segment's target.
Segment segment_until(const Segment& segment, double t_s);

/// Plans the rest of a stopped motion anew, from rest: no speed is above what was planned, and each segment
/// ends with the speed that was planned or with the highest one that it can reach. Their start_s is yet to be
/// told.
std::vector<Segment> restart_motion(std::vector<Segment> rest, const rrs::JointPos& acceleration);

}  // namespace gsim::motion
