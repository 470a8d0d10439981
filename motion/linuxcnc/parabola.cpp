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
double reached_speed(const Piece& piece, double acceleration, double share) {
    const double length = piece.settled ? piece.length : piece.length / 2;
    double speed = std::sqrt(acceleration * length);
    if (std::isfinite(piece.jerk)) speed = std::min(speed, peak_speed(length, acceleration, piece.path_jerk));
    return std::min(speed, target_speed(piece, share));
}

double time_to_reach(double speed, double acceleration, const Piece& piece) {
    return std::isfinite(piece.jerk) ? ramp_s(0, speed, acceleration, piece.path_jerk) : speed / acceleration;
}

// The square root is LinuxCNC's own (calcSCurveSpeedWithT() in sp_scurve.c). Speeds fall as the jerk grows,
// and its units do not fit. So it matters that LinuxCNC counts in degrees if only rotary joints move.
double reached_after(double time_s, double acceleration, const Piece& piece, double jerk) {
    const double straight = time_s * acceleration;
    if (std::isinf(jerk)) return straight;
    const double unit = piece.path_limited ? 1 : kRadPerDeg;
    return std::min(straight, acceleration * std::sqrt(time_s * unit / jerk));
}

// Returns the speed from which a stop takes the length that the tolerance leaves.
double speed_within(double tolerance, double sharpness, double acceleration, double jerk) {
    if (std::isinf(jerk)) return 2 * std::sqrt(acceleration * tolerance / sharpness);
    const double root = std::cbrt(12 * tolerance / sharpness * std::sqrt(jerk));
    return root * root;
}

Vector3d level_tangent(const Arc& arc, double phi_rad) {
    return std::cos(phi_rad) * arc.v - std::sin(phi_rad) * arc.u;
}

// A line without motion in X, Y and Z counts as one along X.
Vector3d direction_of_line(const Piece& line) {
    return line.direction.isZero() ? Vector3d::UnitX() : line.direction;
}

Vector3d end_direction_of(const Piece& piece) {
    return piece.curved ? level_tangent(piece.arc, piece.arc.sweep_rad) : direction_of_line(piece);
}

// An arc starts in the direction of its full acceleration at half of its speed.
Vector3d start_direction_of(const Piece& piece) {
    if (!piece.curved) return direction_of_line(piece);
    const double speed = piece.requested_speed / 2;
    const double across = speed * speed / piece.arc.radius_mm;
    return (whole_acceleration(piece) * level_tangent(piece.arc, 0) - across * piece.arc.u).normalized();
}

// Returns the program's tolerance, in degrees if only rotary joints move.
double parabola_tolerance(const Piece& piece) {
    return piece.path_limited ? piece.tolerance_mm : piece.tolerance_mm * kRadPerDeg;
}

}  // namespace

Parabola parabola_between(const Piece& before, const Piece& after, double share_before, double share_after) {
    const double a_before = acceleration(before), a_after = acceleration(after);
    const double v_before = reached_speed(before, a_before, share_before);
    const double v_after = reached_speed(after, a_after, share_after);
    const double blend_s = std::min(
        {before.length / v_before, after.length / v_after,
         std::max(time_to_reach(v_before, a_before, before), time_to_reach(v_after, a_after, after))});
    double from = std::min(v_before, reached_after(blend_s, a_before, before, before.jerk));
    double to = std::min(v_after, reached_after(blend_s, a_after, after, before.jerk));
    const double half_angle_rad =
        std::acos(std::clamp(-end_direction_of(before).dot(start_direction_of(after)), -1.0, 1.0)) / 2;
    const double sharpness = std::cos(half_angle_rad);
    if (before.tolerance_mm > 0 && sharpness > std::sin(kStraight_rad)) {
        const double within = speed_within(parabola_tolerance(before), sharpness, a_before, before.jerk);
        from = std::min(from, within);
        to = std::min(to, within);
    }
    return {from, to, std::sin(half_angle_rad) * (from + to) / 2};
}

}  // namespace gsim::motion::linuxcnc
