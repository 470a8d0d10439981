#include "motion/linuxcnc/velocity_planner.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/linuxcnc/parabola.h"

namespace gsim::motion::linuxcnc {

namespace {

constexpr double kMinRampTime_s = 0.01;  // feed sub-segments of less time than this are one ramp
constexpr std::size_t kMaxRetainedSubSegments =
    4;  // a group's end never starts to be shared earlier than with these

// Returns the limit that kept the sub-segment from being faster. `slowed_by` is the limit of the speed at its
// end.
LimitCause limit_cause(const SubSegment& sub_segment, double share, const Law& law, bool starts_at_standstill,
                       bool ends_at_standstill, LimitKind slowed_by) {
    if (law.top_speed() >= target_speed(sub_segment, share) * (1 - 1e-6)) {
        return sub_segment.rapid && share < 1 ? LimitCause{LimitKind::rapid_override, -1}
                                              : sub_segment.limits.speed_limit;
    }
    if (starts_at_standstill && ends_at_standstill) return sub_segment.limits.acceleration_limit;
    if (starts_at_standstill || ends_at_standstill) return {LimitKind::stop, -1};
    return {slowed_by, -1};
}

constexpr double kRemainderTolerance = 1e-6;  // mm or degrees
constexpr double kMinLengthFactor = 1000;     // times that: shorter distances run to their end

// LinuxCNC ends an S-curve in the first period in which almost no distance remains. The returned law ends
// with that period; `before_s` is the time before the law.
Law trim_creep(const Law& law, const SubSegment& sub_segment, double before_s, double period_s) {
    const double negligible = kRemainderTolerance * (sub_segment.limits.path_limited ? 1 : kRadPerDeg);
    if (std::isinf(sub_segment.limits.jerk) || law.length() < kMinLengthFactor * negligible) return law;
    const double min_s = before_s + law.time_at(law.length() - negligible);
    const double end_s = std::ceil(min_s / period_s - kPeriodTolerance) * period_s - before_s;
    return end_s < law.duration_s() ? law.shortened(law.duration_s() - end_s) : law;
}

}  // namespace

void VelocityPlanner::advance(SubSegmentQueue& queue, bool ended) {
    ended_ = ended;
    final_count_ = ended || queue.empty() ? queue.size() : queue.size() - 1;
    while (next_ < final_count_) {
        find_run_end(queue);
        if (!can_plan_next(queue)) return;
        plan_next(queue);
    }
}

std::size_t VelocityPlanner::ready() const {
    return next_ - std::min(group_.sub_segments, kMaxRetainedSubSegments);
}

void VelocityPlanner::drop(std::size_t count) {
    next_ -= count;
    tangent_end_ = std::max(tangent_end_, count) - count;
}

void VelocityPlanner::clear() {
    *this = VelocityPlanner(depth_, clock_, planning_, *axes_);
}

// Each sub-segment is checked once: the next search continues at the end of the last one.
void VelocityPlanner::find_run_end(const SubSegmentQueue& queue) {
    tangent_end_ = std::max(tangent_end_, next_);
    const auto tangent = [&](std::size_t index) {
        return queue[index].sub_segment.junctions.end_condition == EndCondition::tangent &&
               !(ended_ && index + 1 == final_count_);
    };
    while (tangent_end_ < final_count_ && tangent(tangent_end_)) ++tangent_end_;
    is_end_known_ = tangent_end_ < final_count_;
}

// The first sub-segment of the next group must also be known at the end of a group.
bool VelocityPlanner::can_plan_next(const SubSegmentQueue& queue) const {
    if (!is_end_known_) return next_ + depth_ < final_count_;
    const bool blends =
        tangent_end_ == next_ && queue[next_].sub_segment.junctions.end_condition == EndCondition::parabola;
    return !blends || ended_ || next_ + 1 < final_count_;
}

Horizon VelocityPlanner::horizon() const {
    Horizon horizon;
    if (is_end_known_) horizon.tangent_run_end = tangent_end_;
    horizon.is_queue_end = ended_ && tangent_end_ + 1 == final_count_;
    horizon.depth = depth_;
    return horizon;
}

void VelocityPlanner::plan_next(SubSegmentQueue& queue) {
    const bool starts_at_standstill = group_.sub_segments == 0;
    LimitKind slowed_by = LimitKind::corner;
    const Profile profile =
        schedule_ != nullptr ? overridden_profile(queue, slowed_by) : make_profile(queue, slowed_by);
    QueuedSubSegment& queued = queue[next_];
    queued.is_group_end = is_end_known_ && tangent_end_ == next_;
    queued.overlap_time_s = queued.emitted_s = 0;
    queued.law = profile.law;
    queued.limited_by = limit_cause(queued.sub_segment, override_share(queued.sub_segment), queued.law,
                                    starts_at_standstill, queued.is_group_end, slowed_by);
    ++next_;
    ++group_.sub_segments;
    group_.duration_s += queued.law.duration_s();
    group_.speed = profile.end_speed;
    group_.acceleration = profile.end_acceleration;
    if (queued.is_group_end) end_group(queue, profile);
}

Profile VelocityPlanner::make_profile(SubSegmentQueue& queue, LimitKind& slowed_by) {
    return is_end_known_ && tangent_end_ == next_ ? last_profile(queue) : passing_profile(queue, slowed_by);
}

Profile VelocityPlanner::passing_profile(const SubSegmentQueue& queue, LimitKind& slowed_by) const {
    const SubSegment& sub_segment = queue[next_].sub_segment;
    const JunctionSpeed junction = planning_.s_curves ? curved_junction_speed(queue, next_, horizon())
                                                      : junction_speed(queue, next_, horizon());
    slowed_by = junction.limit;
    const double target_speed_limit = target_speed(sub_segment, override_share(sub_segment));
    const SubSegment& following = queue[next_ + 1].sub_segment;
    const double end_speed =
        std::min({junction.speed, target_speed_limit, target_speed(following, override_share(following))});
    const double mean_speed = (group_.speed + std::min(junction.speed, target_speed_limit)) / 2;
    const Law start = start_law(sub_segment);
    const double from = start_speed(start);
    Stretch section = make_path_section(sub_segment);
    section.length -= start.length();
    const bool reaches_end_speed =
        from * from + 2 * section.acceleration * section.length <= end_speed * end_speed;
    const bool is_short = !planning_.s_curves && sub_segment.length < kMinRampTime_s * mean_speed;
    if (!reaches_end_speed && !sub_segment.rapid && end_speed > 0 && is_short) {
        return ramp(sub_segment.length, group_.speed, end_speed);
    }
    return append_profile(start, from_speed_to_speed(section, from, end_speed));
}

// A group takes full periods: it dwells for the remainder of the last one.
Profile VelocityPlanner::last_profile(const SubSegmentQueue& queue) {
    Stretch section = make_path_section(queue[next_].sub_segment);
    const bool has_late_overlap = overlaps_late(queue, next_);
    const bool starts_at_standstill = group_.sub_segments == 0 && overlap_acceleration_ <= 0;
    if (starts_at_standstill && !has_late_overlap && std::isinf(section.jerk))
        return rest_to_rest(section, clock_);
    const Law start = start_law(queue[next_].sub_segment);
    section.length -= start.length();
    Profile profile = append_profile(start, from_speed_to_speed(section, start_speed(start), 0));
    if (has_late_overlap) profile = late_overlap_profile(queue, profile);
    if (!clock_.counts) return profile;
    profile.law = trim_creep(profile.law, queue[next_].sub_segment, group_.duration_s, clock_.period_s);
    const double motion_s = group_.duration_s + profile.law.duration_s();
    const double period_remainder_s =
        std::ceil(motion_s / clock_.period_s - kPeriodTolerance) * clock_.period_s - motion_s;
    profile.law.standstill(period_remainder_s);
    if (has_late_overlap) profile.braking_time_s += period_remainder_s;
    return profile;
}

void VelocityPlanner::end_group(SubSegmentQueue& queue, const Profile& profile) {
    const QueuedSubSegment& last = queue[next_ - 1];
    double overlap = 0;
    const bool has_late_overlap = overlaps_late(queue, next_ - 1);
    overlap_acceleration_ = 0;
    if (last.sub_segment.junctions.end_condition == EndCondition::parabola && next_ < queue.size()) {
        overlap = has_late_overlap ? profile.braking_time_s : overlap_s(queue, profile);
        if (has_late_overlap) overlap_acceleration_ = overlap_acceleration(queue);
        overlap = std::clamp(overlap, 0.0, std::max(0.0, group_.duration_s - overlap_before_s_));
        assign_overlap(queue, overlap);
    }
    overlap_before_s_ = overlap;
    group_start_s_ += group_.duration_s - overlap;
    group_ = {};
}

// The next sub-segment starts in the first period in which the last one, as it brakes, is slow enough.
double VelocityPlanner::overlap_s(const SubSegmentQueue& queue, const Profile& profile) const {
    const SubSegment& last = queue[next_ - 1].sub_segment;
    const SubSegment& next = queue[next_].sub_segment;
    const double before = parabola_between(last, next, override_share(last), override_share(next)).before;
    const double braking_time_s = profile.braking_time_s;
    const double slowing_s =
        std::isfinite(last.limits.jerk) ? time_below_speed_s(profile, before) : before / acceleration(last);
    if (!clock_.counts) return std::min(slowing_s, braking_time_s);
    const double slow = slowing_s / clock_.period_s, brake = braking_time_s / clock_.period_s;
    const double periods = std::ceil(brake - kPeriodTolerance);
    return clock_.period_s *
           (brake < slow ? periods + 1 : periods - std::floor(brake - slow + kPeriodTolerance));
}

void VelocityPlanner::assign_overlap(SubSegmentQueue& queue, double overlap_s) const {
    const std::size_t first = next_ - std::min(next_, group_.sub_segments);
    for (std::size_t index = next_; index > first && overlap_s > 0; --index) {
        QueuedSubSegment& queued = queue[index - 1];
        queued.overlap_time_s = std::min(overlap_s, queued.remaining_s());
        overlap_s -= queued.overlap_time_s;
    }
}

}  // namespace gsim::motion::linuxcnc
