#pragma once

#include "motion/lookahead/block.h"

namespace gsim::motion {

// A corner between two lines is rounded by executing the end of the one and the start of the other at the
// same time. Both are cut short by d, and the cut ends are passed in the time T = 2 d / v, with the
// parametric speed v kept. The velocities of the joints change from v s to v s' by v (s + (s' - s) f(t / T)).
// Here s and s' are the changes of the joints per length of the two paths, and f grows from 0 to 1 with f(1 -
// u) = 1 - f(u). So each joint's speed stays between the two that it has on the lines. The results are:
//
//                                     parabolic, f = u       smooth, f = 2 u^2 up to u = 1/2
//   highest acceleration of a joint   v^2 |s' - s| / (2 d)   v^2 |s' - s| / d
//   jerk                              infinite at the ends   v^3 |s' - s| / d^2
//   nearest to the corner             d |s' - s| / 4         d |s' - s| / 6

/// Returns the remaining distance of each line from the middle of a blend to the corner, as a share of the
/// cut.
constexpr double corner_distance_share(bool smooth) {
    return smooth ? 1.0 / 6 : 1.0 / 4;
}

/// Largest share of a line that one blend may cut off. A blend is passed at one speed, so a length must
/// remain between two of them for speeding up.
inline constexpr double kMaxCutShare = 0.4;

/// Blend and the speed at which it may be passed.
struct BlendedCorner {
    Blend blend;
    double speed = 0;
    bool is_within_speed_steps =
        false;  ///< The joints' steps surely cover this corner and those in front of it.
};

/// Returns the blend of two lines with the same measure. It is as fast as the tolerances, half of either
/// line, and the accelerations and jerks of the joints and of the path allow. Jerks count if the controller
/// limits them. It is no faster than `speed_cap`, and no larger than that speed needs. Returns no blend and
/// the speed 0 if nothing may be cut off; no blend and a speed if nothing has to be.
BlendedCorner blend_between(const PlannerSetup& setup, const Block& from, const Block& to, bool smooth,
                            double speed_cap);

/// True if the blend of a corner takes less time than passing it exactly at `exact_speed`. Both cover the
/// same distance, to and from the highest speed, at most `speed_cap`, that is reached from the blend on half
/// of either line.
bool saves_time(const BlendedCorner& blended, double exact_speed, const Block& from, const Block& to,
                double speed_cap);

/// Returns the blend at the start of `to`, no larger than `speed` needs. It was planned for a higher speed.
Blend blend_at(const PlannerSetup& setup, const Block& from, const Block& to, double speed);

/// Returns the speed below which a stop at the corner is better than its blend. It is a share, below those of
/// full blends, of the speed from which the cut is long enough to stop. Both then take about the same time.
double min_blend_speed(const Block& from, const Block& to);

/// Outputs the blend at the start of `to`, passed at `speed` > 0, as two segments: the path to the point
/// nearest to the corner, at which the first move reaches its target, and the path from there.
void emit_blend(const Block& from, const Block& to, double speed, LimitCause limited_by,
                SegmentOutput& output);

}  // namespace gsim::motion
