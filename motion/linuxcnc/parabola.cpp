#include "motion/linuxcnc/parabola.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/linuxcnc/profile.h"
#include "motion/profile/ramp.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kStraight_rad = 0.001;  // a turn by less than twice this needs no tolerance

// Returns the speed that a sub-segment reaches if it has to stop again.
double reachable_speed_to_stop(const SubSegment& sub_segment, double acceleration, double share) {
    const double length = sub_segment.is_final ? sub_segment.length : sub_segment.length / 2;
    double speed = std::sqrt(acceleration * length);
    if (std::isfinite(sub_segment.limits.jerk))
        speed = std::min(speed, peak_speed(length, acceleration, sub_segment.limits.path_jerk));
    return std::min(speed, target_speed(sub_segment, share));
}

double time_to_reach(double speed, double acceleration, const SubSegment& sub_segment) {
    return std::isfinite(sub_segment.limits.jerk)
               ? ramp_s(0, speed, acceleration, sub_segment.limits.path_jerk)
               : speed / acceleration;
}

// The square root is LinuxCNC's own (calcSCurveSpeedWithT() in sp_scurve.c). Speeds fall as the jerk grows,
// and its units do not fit. So it matters that LinuxCNC counts in degrees if only rotary joints move.
double speed_after(double time_s, double acceleration, const SubSegment& sub_segment, double jerk) {
    const double trapezoid_speed = time_s * acceleration;
    if (std::isinf(jerk)) return trapezoid_speed;
    const double unit = sub_segment.limits.path_limited ? 1 : kRadPerDeg;
    return std::min(trapezoid_speed, acceleration * std::sqrt(time_s * unit / jerk));
}

// Returns the speed from which a stop takes the length that the tolerance leaves.
double speed_within_tolerance(double tolerance, double sharpness, double acceleration, double jerk) {
    if (std::isinf(jerk)) return 2 * std::sqrt(acceleration * tolerance / sharpness);
    const double root = std::cbrt(12 * tolerance / sharpness * std::sqrt(jerk));
    return root * root;
}

Vector3d in_plane_tangent(const Arc& arc, double phi_rad) {
    return std::cos(phi_rad) * arc.v - std::sin(phi_rad) * arc.u;
}

// A line without motion in X, Y and Z counts as one along X.
Vector3d line_direction(const SubSegment& line) {
    return line.direction.isZero() ? Vector3d::UnitX() : line.direction;
}

Vector3d parabola_end_direction(const SubSegment& sub_segment) {
    return sub_segment.curved ? in_plane_tangent(sub_segment.arc, sub_segment.arc.sweep_rad)
                              : line_direction(sub_segment);
}

// An arc starts in the direction of its full acceleration at half of its speed.
Vector3d parabola_start_direction(const SubSegment& sub_segment) {
    if (!sub_segment.curved) return line_direction(sub_segment);
    const double speed = sub_segment.limits.requested_speed / 2;
    const double normal_acceleration = speed * speed / sub_segment.arc.radius_mm;
    return (total_acceleration(sub_segment) * in_plane_tangent(sub_segment.arc, 0) -
            normal_acceleration * sub_segment.arc.u)
        .normalized();
}

// Returns the program's tolerance, in degrees if only rotary joints move.
double parabola_tolerance(const SubSegment& sub_segment) {
    return sub_segment.limits.path_limited ? sub_segment.junctions.tolerance_mm
                                           : sub_segment.junctions.tolerance_mm * kRadPerDeg;
}

}  // namespace

Parabola parabola_between(const SubSegment& before, const SubSegment& after, double share_before,
                          double share_after) {
    const double a_before = acceleration(before), a_after = acceleration(after);
    const double v_before = reachable_speed_to_stop(before, a_before, share_before);
    const double v_after = reachable_speed_to_stop(after, a_after, share_after);
    const double blend_s = std::min(
        {before.length / v_before, after.length / v_after,
         std::max(time_to_reach(v_before, a_before, before), time_to_reach(v_after, a_after, after))});
    double from = std::min(v_before, speed_after(blend_s, a_before, before, before.limits.jerk));
    double to = std::min(v_after, speed_after(blend_s, a_after, after, before.limits.jerk));
    const double half_angle_rad =
        std::acos(
            std::clamp(-parabola_end_direction(before).dot(parabola_start_direction(after)), -1.0, 1.0)) /
        2;
    const double sharpness = std::cos(half_angle_rad);
    if (before.junctions.tolerance_mm > 0 && sharpness > std::sin(kStraight_rad)) {
        const double within =
            speed_within_tolerance(parabola_tolerance(before), sharpness, a_before, before.limits.jerk);
        from = std::min(from, within);
        to = std::min(to, within);
    }
    return {from, to, std::sin(half_angle_rad) * (from + to) / 2};
}

}  // namespace gsim::motion::linuxcnc
