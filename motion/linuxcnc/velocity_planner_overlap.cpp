// A sub-segment has its full acceleration until the next one starts, since release 2.10. From then on it has
// half of it, which is too little for its remaining distance: it arrives with speed, and stops within a
// period.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/linuxcnc/parabola.h"
#include "motion/linuxcnc/velocity_planner.h"

namespace gsim::motion::linuxcnc {

namespace {

// Share of the initial speed that is lost, at half of the acceleration, when the distance is used up.
constexpr double kLostSpeedShare = 1 - 1 / std::numbers::sqrt2;

}  // namespace

bool VelocityPlanner::overlaps_late(const SubSegmentQueue& queue, std::size_t index) const {
    return planning_.since_2_10 && !planning_.s_curves &&
           queue[index].sub_segment.junctions.end_condition == EndCondition::parabola &&
           index + 1 < queue.size();
}

/// Returns how the next sub-segment begins, if it is the first of its group and the last one is still active,
/// or if it begins with an acceleration.
Law VelocityPlanner::start_law(const SubSegment& sub_segment) const {
    Law start;
    if (group_.acceleration != 0 && std::isfinite(sub_segment.limits.jerk)) {
        start = acceleration_ramp_down(group_.speed, group_.acceleration, sub_segment.limits.jerk);
        return start.length() < sub_segment.length ? start : Law();
    }
    if (group_.sub_segments > 0 || overlap_acceleration_ <= 0) return start;
    const double mid_time_s = std::sqrt(sub_segment.length / overlap_acceleration_);
    start.add(std::min(overlap_before_s_, mid_time_s), 0, overlap_acceleration_);
    return start;
}

/// Returns the profile of the last sub-segment of a group that stops, with half of the acceleration from the
/// start of the next one on.
Profile VelocityPlanner::late_overlap_profile(const SubSegmentQueue& queue, const Profile& profile) const {
    const SubSegment& sub_segment = queue[next_].sub_segment;
    const SubSegment& next = queue[next_ + 1].sub_segment;
    const double a = isolated_acceleration(sub_segment, planning_);
    const double blend_s =
        parabola_between(sub_segment, next, override_share(sub_segment), override_share(next)).before / a;
    const double periods = std::max(0.0, std::floor((profile.braking_time_s - blend_s) / planning_.period_s));
    const double halved_time_s = std::max(0.0, profile.braking_time_s - periods * planning_.period_s);
    Profile late_profile;
    late_profile.law = profile.law.part(0, profile.law.duration_s() - halved_time_s);
    late_profile.braking_time_s = 2 * kLostSpeedShare * halved_time_s;
    late_profile.law.add(late_profile.braking_time_s, halved_time_s * a, -a / 2);
    return late_profile;
}

/// Returns the acceleration of the next sub-segment while it overlaps the last one. Its speed rises with the
/// last one's speed.
double VelocityPlanner::overlap_acceleration(const SubSegmentQueue& queue) const {
    const SubSegment& last = queue[next_ - 1].sub_segment;
    const SubSegment& next = queue[next_].sub_segment;
    const Parabola parabola = parabola_between(last, next, override_share(last), override_share(next));
    const double acceleration_gain =
        isolated_acceleration(last, planning_) * parabola.after / parabola.before;
    return std::min(acceleration_gain, isolated_acceleration(next, planning_)) / 2;
}

}  // namespace gsim::motion::linuxcnc
