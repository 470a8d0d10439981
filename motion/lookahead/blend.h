#pragma once

#include "motion/lookahead/block.h"

namespace gsim::motion {

// A corner between two lines is rounded by doing the end of the one and the start of the other at the same
// time. Both are cut short by d, and the cut ends are passed in the time T = 2 d / v, with the parametric
// speed v kept: the velocities of the joints go from v s to v s' by v (s + (s' - s) f(t / T)), where s and s'
// are the changes of the joints by length of the two ways and f grows from 0 to 1 with f(1 - u) = 1 - f(u).
// So each joint's speed stays between the two that it has on the lines. What comes of it:
//
//                                     parabolic, f = u       smooth, f = 2 u^2 up to u = 1/2
//   highest acceleration of a joint   v^2 |s' - s| / (2 d)   v^2 |s' - s| / d
//   jerk                              infinite at the ends   v^3 |s' - s| / d^2
//   nearest to the corner             d |s' - s| / 4         d |s' - s| / 6

/// The way that each line has left from the middle of a blend to the corner, as a share of the cut.
constexpr double blend_share(bool smooth) {
    return smooth ? 1.0 / 6 : 1.0 / 4;
}

/// What one blend may cut off a line at most, as a share of it. A blend is passed at one speed: between two
/// of them something must be left on which to speed up.
inline constexpr double kMostOfLine = 0.4;

/// A blend and the speed at which it may be passed.
struct BlendedCorner {
    Blend blend;
    double speed = 0;
    bool steps_cover = false;  ///< The joints' steps surely cover this corner and those in front of it.
};

/// The blend of two lines whose measures are the same: as fast as the tolerances, half of either line and the
/// accelerations and jerks (where the controller limits them) of the joints and of the path allow, but no
/// faster than `most`; and no larger than that speed needs. No blend, and the speed 0, where nothing may be
/// cut off; no blend, and a speed, where nothing has to be.
BlendedCorner blend_between(const PlannerSetup& setup, const Block& from, const Block& to, bool smooth,
                            double most);

/// Whether the blend of a corner takes less time than to pass it exactly at `exact_speed`, over the same way
/// and to and from the highest speed, at most `most`, that is reached from the blend on half of either line.
bool saves_time(const BlendedCorner& blended, double exact_speed, const Block& from, const Block& to,
                double most);

/// The blend at the start of `to`, which was planned for a higher speed, no larger than `speed` needs.
Blend blend_at(const PlannerSetup& setup, const Block& from, const Block& to, double speed);

/// The speed below which it is better to stop at the corner than to pass its blend: a share, below those of
/// full blends, of the one from which the cut is long enough to stop. Both ways then take about as long.
double least_blend_speed(const Block& from, const Block& to);

/// Puts out the blend at the start of `to`, passed at `speed` > 0, as two segments: the way to the point
/// that is nearest to the corner, where the first move reaches its target, and the way from there.
void put_out_blend(const Block& from, const Block& to, double speed, LimitedBy limited_by,
                   SegmentOutput& output);

}  // namespace gsim::motion
