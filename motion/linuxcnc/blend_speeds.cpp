#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/linuxcnc/blend_arc.h"
#include "motion/linuxcnc/profile.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kMinCorner_rad = 1e-6;
constexpr double kMinArc_mm = 1e-6;
constexpr double kMinBlendRadius_mm = 1e-12;

double blend_tolerance_mm(const SubSegment& sub_segment) {
    const double share = sub_segment.nominal_length / 4;
    return sub_segment.junctions.tolerance_mm > 0 ? std::min(sub_segment.junctions.tolerance_mm, share)
                                                  : share;
}

// Returns the speed at which the change from one line's limits to the other's is the tightest.
double turn_speed_limit(const SubSegment& before, const SubSegment& after, const Leg& leg_before,
                        const Leg& leg_after, double turn_rad) {
    const double shared = std::cos(std::min(turn_rad, 0.49 * std::numbers::pi));
    const double in = std::min(before.limits.max_speed, after.limits.max_speed / shared);
    const double out = std::min(after.limits.max_speed, before.limits.max_speed / shared);
    const double change = (leg_after.direction * out - leg_before.direction * in).norm();
    return change > 0 ? in * out * std::sin(turn_rad) / change : 0;
}

double override_speed(const SubSegment& sub_segment) {
    return std::min(sub_segment.limits.requested_speed, sub_segment.limits.max_speed);
}

// LinuxCNC does not know the speed that a spindle will request and plans for the maximum (tcGetMaxTargetVel()
// in tc.c).
double planned_speed(const SubSegment& sub_segment) {
    return sub_segment.follows_spindle ? sub_segment.limits.max_speed : override_speed(sub_segment);
}

bool is_wide_enough(const BlendSpeeds& blend, double turn_rad) {
    return blend.radius_mm >= kMinBlendRadius_mm && blend.radius_mm * turn_rad >= kMinArc_mm;
}

}  // namespace

std::optional<BlendSpeeds> blend_speeds(const SubSegment& before, const SubSegment& after,
                                        const Corner& corner, const Leg& leg_before, const Leg& leg_after,
                                        const Axes& axes) {
    const double corner_rad = corner.half_angle_rad;
    if (std::min(corner_rad, std::numbers::pi / 2 - corner_rad) < kMinCorner_rad) return std::nullopt;
    BlendSpeeds blend;
    blend.half_angle_rad = std::min(leg_before.half_angle_rad, leg_after.half_angle_rad);
    blend.tolerance_mm = std::min(blend_tolerance_mm(before), blend_tolerance_mm(after));
    blend.acceleration = Axes::in_plane(axes.max_acceleration_mm_s2(), corner.normal);
    blend.requested_speed = std::max(override_speed(before), override_speed(after));

    const double sine = std::sin(blend.half_angle_rad), cosine = std::cos(blend.half_angle_rad);
    const double turn_rad = std::numbers::pi - 2 * blend.half_angle_rad;
    const bool lines = !leg_before.curved && !leg_after.curved;
    const double turning_speed_limit =
        lines ? turn_speed_limit(before, after, leg_before, leg_after, turn_rad) : 0;
    const double goal =
        std::min(std::max(planned_speed(before), planned_speed(after)),
                 std::max(turning_speed_limit, Axes::in_plane(axes.max_speed_mm_s(), corner.normal)));

    const double cut_mm =
        std::min({leg_before.available_mm, leg_after.available_mm, blend.tolerance_mm * cosine / (1 - sine)});
    const double normal_acceleration = kNormalShare * blend.acceleration;
    const double max_radius_mm = cut_mm * sine / cosine;
    blend.speed = std::min(std::sqrt(normal_acceleration * max_radius_mm), goal);
    const double jerk =
        std::min({before.limits.jerk, after.limits.jerk, before.limits.path_jerk, after.limits.path_jerk});
    if (std::isfinite(jerk))
        blend.speed = std::min(blend.speed, peak_speed(max_radius_mm, normal_acceleration, jerk));
    // The arc must be long enough to turn at this speed, or to reach it.
    const double along = blend.acceleration / 2;
    const double ramp_s = std::min(std::sqrt(2 * along * cut_mm), blend.speed) / along;
    blend.radius_mm = std::max(blend.speed * blend.speed / normal_acceleration,
                               std::min(ramp_s * blend.speed / turn_rad, max_radius_mm));
    if (std::isfinite(jerk))
        blend.radius_mm = std::max(blend.radius_mm, blend.speed * std::sqrt(blend.speed / jerk));
    if (!is_wide_enough(blend, turn_rad)) return std::nullopt;
    return blend;
}

}  // namespace gsim::motion::linuxcnc
