// Operator overrides in the velocity planner: in each period the controller aims at the speed that they
// request then.

#include <algorithm>
#include <cmath>

#include "motion/linuxcnc/sub_segment_path.h"
#include "motion/linuxcnc/velocity_planner.h"
#include "motion/segment/move_part.h"

namespace gsim::motion::linuxcnc {

Stretch VelocityPlanner::make_path_section(const SubSegment& sub_segment) const {
    return {sub_segment.length, target_speed(sub_segment, override_share(sub_segment)),
            isolated_acceleration(sub_segment, planning_), sub_segment.limits.jerk};
}

/// Returns the motion of the next sub-segment, or of its part up to an override change. The other part is
/// then the next sub-segment.
Profile VelocityPlanner::overridden_profile(SubSegmentQueue& queue, LimitKind& slowed_by) {
    const double start_s = group_start_s_ + group_.duration_s;
    overrides_ = schedule_->at(start_s);
    const SubSegment& sub_segment = queue[next_].sub_segment;
    const bool on_hold = override_share(sub_segment) <= 0;
    if (on_hold && group_.speed > kStandstillTolerance) {
        const Profile brake_profile = braking_profile(queue);
        return cut_profile(queue, brake_profile, schedule_->next_change_s(start_s) - start_s);
    }
    double from_s = on_hold
                        ? schedule_->release_time_s(start_s, sub_segment.enabled_overrides, sub_segment.rapid)
                        : start_s;
    overrides_ = schedule_->at(from_s);
    Profile profile = make_profile(queue, slowed_by);
    double next_s = schedule_->next_change_s(from_s);
    while (profile.law.at(next_s - from_s) <= kMinPart && std::isfinite(next_s)) {
        overrides_ = schedule_->at(next_s);
        if (override_share(sub_segment) <= 0) break;
        profile = make_profile(queue, slowed_by);
        next_s = schedule_->next_change_s(next_s);
    }
    if (from_s > start_s) {
        Law standstill;
        standstill.standstill(from_s - start_s);
        profile = append_profile(standstill, profile);
    }
    return cut_profile(queue, profile, next_s - start_s);
}

/// Brakes as hard as the sub-segment can, to standstill or to its end.
Profile VelocityPlanner::braking_profile(SubSegmentQueue& queue) {
    const SubSegment& sub_segment = queue[next_].sub_segment;
    if (std::isfinite(sub_segment.limits.jerk)) return curved_braking_profile(queue);
    const double a = isolated_acceleration(sub_segment, planning_);
    const double distance = group_.speed * group_.speed / (2 * a);
    if (distance < sub_segment.length - kMinPart) {
        split(queue, std::max(distance, kMinPart));
        return ramp(queue[next_].sub_segment.length, group_.speed, 0);
    }
    const bool stops = is_end_known_ && tangent_end_ == next_;
    const double square = group_.speed * group_.speed - 2 * a * sub_segment.length;
    return ramp(sub_segment.length, group_.speed, stops ? 0 : std::sqrt(std::max(square, 0.0)));
}

Profile VelocityPlanner::curved_braking_profile(SubSegmentQueue& queue) {
    const SubSegment& sub_segment = queue[next_].sub_segment;
    const Law start = start_law(sub_segment);
    Stretch section = make_path_section(sub_segment);
    section.length -= start.length();
    const double from = start_speed(start);
    const bool stops = is_end_known_ && tangent_end_ == next_;
    const Profile brake_profile = append_profile(start, braking(section, from, stops ? 0 : from));
    if (brake_profile.law.length() < sub_segment.length - kMinPart)
        split(queue, std::max(brake_profile.law.length(), kMinPart));
    return brake_profile;
}

/// Returns the motion until `t_s` after its start, if the sub-segment is then on its path.
Profile VelocityPlanner::cut_profile(SubSegmentQueue& queue, const Profile& profile, double t_s) {
    if (!(t_s < profile.law.duration_s())) return profile;
    const double distance = profile.law.at(t_s);
    if (distance <= kMinPart || distance >= queue[next_].sub_segment.length - kMinPart) return profile;
    Profile part;
    part.law = profile.law.part(0, t_s);
    part.end_speed = profile.law.speed_at(t_s);
    if (std::isfinite(queue[next_].sub_segment.limits.jerk))
        part.end_acceleration = part.law.end_acceleration();
    split(queue, distance);
    return part;
}

/// Cuts the next sub-segment into two, which meet at speed.
void VelocityPlanner::split(SubSegmentQueue& queue, double length) {
    queue.duplicate(next_);
    ++tangent_end_;
    ++final_count_;
    SubSegment& first = queue[next_].sub_segment;
    SubSegment& second = queue[next_ + 1].sub_segment;
    const bool is_halved =
        first.junctions.after_parabola || first.junctions.end_condition == EndCondition::parabola;
    const bool is_on_lead_in = first.lead_in.length > 0 && length <= first.lead_in.length + kMinPart;
    if (is_on_lead_in) length = std::min(length, first.lead_in.length);
    const SubSegment full_sub_segment = first;
    const PathPart part =
        path_part(full_sub_segment, *axes_, is_on_lead_in ? 0 : full_sub_segment.lead_in.length, length);
    first.end = second.start = part.end;
    first.length = length;
    second.length = full_sub_segment.length - length;
    first.junctions.end_condition = EndCondition::tangent;
    first.junctions.after_parabola = second.junctions.after_parabola = is_halved;
    first.junctions.corner_speed = -1;
    first.deviation_mm = 0;
    if (is_on_lead_in) {
        first.curved = false;
        first.target_id = full_sub_segment.lead_in.target_id;
        first.lead_in.length = 0;
        second.lead_in.length -= length;
        return;
    }
    second.lead_in.length = 0;
    if (!full_sub_segment.curved) return;
    const PathPart standstill = path_part(full_sub_segment, *axes_, length, full_sub_segment.length);
    first.curved = part.curved;
    second.curved = standstill.curved;
    first.arc = part.arc;
    second.arc = standstill.arc;
}

}  // namespace gsim::motion::linuxcnc
