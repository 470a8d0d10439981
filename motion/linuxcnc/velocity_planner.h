#pragma once

#include <cstddef>
#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/look_ahead.h"
#include "motion/linuxcnc/profile.h"
#include "motion/linuxcnc/queued_sub_segment.h"

namespace gsim::motion::linuxcnc {

/// Velocity planner that gives the sub-segments of a queue their time laws, in order, as soon as enough of
/// what follows is known.
///
/// Sub-segments that meet at speed form a group, which starts and ends at standstill and takes full periods.
/// The next group starts before a group stops if that ends with a parabolic blend.
class VelocityPlanner {
  public:
    /// `axes` must outlive it.
    VelocityPlanner(std::size_t depth, const Clock& clock, const PlanningRules& planning, const Axes& axes)
        : depth_(depth), clock_(clock), planning_(planning), axes_(&axes) {}

    /// Starts the first sub-segment of an empty queue at a time of the run, under these overrides (null:
    /// none), which must outlive the queue.
    void start(double at_s, const OverrideSchedule* overrides) {
        group_start_s_ = at_s;
        schedule_ = overrides;
    }

    /// Times the sub-segments that can be timed. The last one of the queue is not final yet, unless the queue
    /// `ended`.
    void advance(SubSegmentQueue& queue, bool ended);
    /// Returns how many sub-segments at the front of the queue can be output: the timed ones, except the last
    /// ones of a group with unknown end, because the next group could start during them.
    std::size_t ready() const;
    /// Notes that the first `count` sub-segments have left the queue.
    void drop(std::size_t count);
    void clear();

  private:
    // Known state of the active group.
    struct Group {
        std::size_t sub_segments = 0;  // timed
        double duration_s = 0;
        double speed = 0;         // at the end of the last timed sub-segment
        double acceleration = 0;  // there, if an override cuts it
    };

    void find_run_end(const SubSegmentQueue& queue);
    bool can_plan_next(const SubSegmentQueue& queue) const;
    Horizon horizon() const;
    void plan_next(SubSegmentQueue& queue);
    Profile make_profile(SubSegmentQueue& queue, LimitKind& slowed_by);
    // Operator overrides (velocity_planner_overrides.cpp).
    double override_share(const SubSegment& sub_segment) const {
        return sub_segment.enabled_overrides.share(overrides_, sub_segment.rapid);
    }
    Stretch make_path_section(const SubSegment& sub_segment) const;
    Profile overridden_profile(SubSegmentQueue& queue, LimitKind& slowed_by);
    Profile braking_profile(SubSegmentQueue& queue);
    Profile curved_braking_profile(SubSegmentQueue& queue);
    Profile cut_profile(SubSegmentQueue& queue, const Profile& profile, double t_s);
    void split(SubSegmentQueue& queue, double length);
    Profile passing_profile(const SubSegmentQueue& queue, LimitKind& slowed_by) const;
    Profile last_profile(const SubSegmentQueue& queue);
    void end_group(SubSegmentQueue& queue, const Profile& profile);
    double overlap_s(const SubSegmentQueue& queue, const Profile& profile) const;
    // Blends that halve the acceleration only while two sub-segments overlap (velocity_planner_overlap.cpp).
    bool overlaps_late(const SubSegmentQueue& queue, std::size_t index) const;
    Law start_law(const SubSegment& sub_segment) const;
    double start_speed(const Law& start) const {
        return start.duration_s() > 0 ? start.end_speed() : group_.speed;
    }
    Profile late_overlap_profile(const SubSegmentQueue& queue, const Profile& profile) const;
    double overlap_acceleration(const SubSegmentQueue& queue) const;
    void assign_overlap(SubSegmentQueue& queue, double overlap_s) const;

    std::size_t depth_;
    Clock clock_;
    PlanningRules planning_;
    const Axes* axes_;
    const OverrideSchedule* schedule_ = nullptr;
    Overrides overrides_;          // when the next sub-segment begins
    double group_start_s_ = 0;     // in run time, of the active group
    std::size_t next_ = 0;         // first sub-segment without a law
    std::size_t tangent_end_ = 0;  // sub-segments from next_ up to here end tangent
    std::size_t final_count_ = 0;  // number of final sub-segments
    bool ended_ = false;           // the last final one is the last of the queue
    bool is_end_known_ = false;    // tangent_end_ ends the run
    Group group_;
    double overlap_before_s_ = 0;      // time by which the active group started before the previous one ended
    double overlap_acceleration_ = 0;  // for so long
};

}  // namespace gsim::motion::linuxcnc
