#include "motion/linuxcnc/sub_segment.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

double acceleration_without_corners(const SubSegment& sub_segment) {
    return sub_segment.limits.full_acceleration *
           (1 - std::max(sub_segment.junctions.start_corner_share, sub_segment.junctions.end_corner_share));
}

}  // namespace

double total_acceleration(const SubSegment& sub_segment) {
    const bool is_halved =
        sub_segment.junctions.after_parabola || sub_segment.junctions.end_condition == EndCondition::parabola;
    return acceleration_without_corners(sub_segment) * (is_halved ? 0.5 : 1.0);
}

double acceleration(const SubSegment& sub_segment) {
    return total_acceleration(sub_segment) * (sub_segment.curved ? sub_segment.limits.tangential_share : 1.0);
}

double isolated_acceleration(const SubSegment& sub_segment, const PlanningRules& planning) {
    if (!planning.since_2_10) return acceleration(sub_segment);
    return acceleration_without_corners(sub_segment) *
           (sub_segment.curved ? sub_segment.limits.tangential_share : 1.0);
}

double target_speed(const SubSegment& sub_segment, double share) {
    const double speed = std::min(sub_segment.limits.requested_speed * share, sub_segment.limits.max_speed);
    return sub_segment.limits.path_limited ? std::min(speed, sub_segment.limits.max_path_speed) : speed;
}

Vector3d start_direction(const SubSegment& sub_segment) {
    return sub_segment.curved ? sub_segment.arc.tangent(0) : sub_segment.direction;
}

Vector3d end_direction(const SubSegment& sub_segment) {
    return sub_segment.curved ? sub_segment.arc.tangent(sub_segment.arc.sweep_rad) : sub_segment.direction;
}

// The length of a spiral is the mean of its path length per angle at both ends.
double timed_arc_length(const Arc& arc) {
    const double radial = (arc.end_radius_mm - arc.radius_mm) / arc.sweep_rad;
    const double length_per_rad =
        (std::hypot(arc.radius_mm, radial) + std::hypot(arc.end_radius_mm, radial)) / 2;
    return std::hypot(arc.sweep_rad * length_per_rad, arc.lift.norm());
}

double effective_radius_mm(const Arc& arc) {
    const double radial = (arc.end_radius_mm - arc.radius_mm) / arc.sweep_rad;
    const double length_per_rad_squared = radial * radial + arc.radius_mm * arc.radius_mm;
    const double radius = length_per_rad_squared * std::sqrt(length_per_rad_squared) /
                          (length_per_rad_squared + radial * radial);
    return arc.lift.squaredNorm() / radius + radius;
}

namespace {

// The limit assumes that the normal acceleration comes within a period at the start of the arc, and again at
// its end.
double speed_by_jerk(const SubSegment& sub_segment, double radius_mm, const PlanningRules& planning) {
    const double normal_jerk_speed = std::cbrt(radius_mm * radius_mm * sub_segment.limits.path_jerk *
                                               sub_segment.arc.sweep_rad / (2 + sub_segment.arc.sweep_rad));
    const double tangential_jerk_speed =
        sub_segment.limits.path_jerk * radius_mm / (3 * kTangentialShare * total_acceleration(sub_segment));
    return std::min({std::sqrt(sub_segment.limits.path_jerk * radius_mm * planning.period_s),
                     normal_jerk_speed, tangential_jerk_speed});
}

void limit_by_acceleration(SubSegment& sub_segment, double radius_mm) {
    const double acceleration_limit = total_acceleration(sub_segment);
    const double normal_acceleration =
        sub_segment.limits.max_speed * sub_segment.limits.max_speed / radius_mm;
    if (normal_acceleration > kNormalShare * acceleration_limit) {
        sub_segment.limits.max_speed = std::sqrt(kNormalShare * acceleration_limit * radius_mm);
        sub_segment.limits.tangential_share = kTangentialShare;
        if (sub_segment.limits.max_speed < sub_segment.limits.requested_speed)
            sub_segment.limits.speed_limit = {LimitKind::centripetal, -1};
        return;
    }
    const double share = normal_acceleration / acceleration_limit;
    sub_segment.limits.tangential_share = std::sqrt(1 - share * share);
}

}  // namespace

void limit_on_arc(SubSegment& sub_segment, const PlanningRules& planning) {
    const double radius_mm = effective_radius_mm(sub_segment.arc);
    limit_by_acceleration(sub_segment, radius_mm);
    if (!std::isfinite(sub_segment.limits.path_jerk)) return;
    const double speed = speed_by_jerk(sub_segment, radius_mm, planning);
    if (speed >= sub_segment.limits.max_speed) return;
    sub_segment.limits.max_speed = speed;
    if (speed < sub_segment.limits.requested_speed) sub_segment.limits.speed_limit = {LimitKind::jerk, -1};
    const double share = speed * speed / radius_mm / total_acceleration(sub_segment);
    if (share < 1) sub_segment.limits.tangential_share = std::sqrt(1 - share * share);
}

void finalize(SubSegment& sub_segment, const PlanningRules& planning) {
    sub_segment.limits.max_speed =
        std::min(sub_segment.limits.max_speed, sub_segment.length / planning.period_s);
    if (sub_segment.curved) limit_on_arc(sub_segment, planning);
    if (sub_segment.junctions.after_tangent) {
        sub_segment.limits.max_speed =
            std::min(sub_segment.limits.max_speed, sub_segment.length / (kMinPeriods * planning.period_s));
    }
    sub_segment.is_final = true;
}

}  // namespace gsim::motion::linuxcnc
