#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/linuxcnc/blend_arc.h"
#include "motion/linuxcnc/profile.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kNoCorner_rad = 1e-6;
constexpr double kSmallestArc_mm = 1e-6;
constexpr double kSmallestBlendRadius_mm = 1e-12;

double tolerance_of(const Piece& piece) {
    const double share = piece.nominal_length / 4;
    return piece.tolerance_mm > 0 ? std::min(piece.tolerance_mm, share) : share;
}

// Returns the speed at which the change from one line's limits to the other's is the tightest.
double turning_speed(const Piece& before, const Piece& after, const Leg& leg_before, const Leg& leg_after,
                     double turn_rad) {
    const double shared = std::cos(std::min(turn_rad, 0.49 * std::numbers::pi));
    const double in = std::min(before.max_speed, after.max_speed / shared);
    const double out = std::min(after.max_speed, before.max_speed / shared);
    const double change = (leg_after.direction * out - leg_before.direction * in).norm();
    return change > 0 ? in * out * std::sin(turn_rad) / change : 0;
}

double wanted_speed(const Piece& piece) {
    return std::min(piece.requested_speed, piece.max_speed);
}

// LinuxCNC does not know the speed that a spindle will request and plans for the maximum (tcGetMaxTargetVel()
// in tc.c).
double planned_speed(const Piece& piece) {
    return piece.follows_spindle ? piece.max_speed : wanted_speed(piece);
}

bool wide_enough(const BlendSpeeds& blend, double turn_rad) {
    return blend.radius_mm >= kSmallestBlendRadius_mm && blend.radius_mm * turn_rad >= kSmallestArc_mm;
}

}  // namespace

std::optional<BlendSpeeds> blend_speeds(const Piece& before, const Piece& after, const Corner& corner,
                                        const Leg& leg_before, const Leg& leg_after, const Axes& axes) {
    const double corner_rad = corner.half_angle_rad;
    if (std::min(corner_rad, std::numbers::pi / 2 - corner_rad) < kNoCorner_rad) return std::nullopt;
    BlendSpeeds blend;
    blend.half_angle_rad = std::min(leg_before.half_angle_rad, leg_after.half_angle_rad);
    blend.tolerance_mm = std::min(tolerance_of(before), tolerance_of(after));
    blend.acceleration = Axes::in_plane(axes.max_acceleration_mm_s2(), corner.normal);
    blend.requested_speed = std::max(wanted_speed(before), wanted_speed(after));

    const double sine = std::sin(blend.half_angle_rad), cosine = std::cos(blend.half_angle_rad);
    const double turn_rad = std::numbers::pi - 2 * blend.half_angle_rad;
    const bool lines = !leg_before.curved && !leg_after.curved;
    const double turning = lines ? turning_speed(before, after, leg_before, leg_after, turn_rad) : 0;
    const double goal = std::min(std::max(planned_speed(before), planned_speed(after)),
                                 std::max(turning, Axes::in_plane(axes.max_speed_mm_s(), corner.normal)));

    const double cut_mm =
        std::min({leg_before.room_mm, leg_after.room_mm, blend.tolerance_mm * cosine / (1 - sine)});
    const double across = kNormalShare * blend.acceleration;
    const double widest_mm = cut_mm * sine / cosine;
    blend.speed = std::min(std::sqrt(across * widest_mm), goal);
    const double jerk = std::min({before.jerk, after.jerk, before.path_jerk, after.path_jerk});
    if (std::isfinite(jerk)) blend.speed = std::min(blend.speed, peak_speed(widest_mm, across, jerk));
    // The arc must be long enough to turn at this speed, or to reach it.
    const double along = blend.acceleration / 2;
    const double ramp_s = std::min(std::sqrt(2 * along * cut_mm), blend.speed) / along;
    blend.radius_mm =
        std::max(blend.speed * blend.speed / across, std::min(ramp_s * blend.speed / turn_rad, widest_mm));
    if (std::isfinite(jerk))
        blend.radius_mm = std::max(blend.radius_mm, blend.speed * std::sqrt(blend.speed / jerk));
    if (!wide_enough(blend, turn_rad)) return std::nullopt;
    return blend;
}

}  // namespace gsim::motion::linuxcnc
