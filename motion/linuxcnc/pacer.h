#pragma once

#include <cstddef>
#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/held_piece.h"
#include "motion/linuxcnc/look_ahead.h"
#include "motion/linuxcnc/profile.h"

namespace gsim::motion::linuxcnc {

/// Velocity planner that gives the sub-segments of a queue their time laws, in order, as soon as enough of
/// what follows is known.
///
/// Sub-segments that meet at speed form a group, which starts and ends at standstill and takes full periods.
/// The next group starts before a group stops if that ends with a parabolic blend.
class Pacer {
  public:
    /// `axes` must outlive it.
    Pacer(std::size_t depth, const Clock& clock, const Planning& planning, const Axes& axes)
        : depth_(depth), clock_(clock), planning_(planning), axes_(&axes) {}

    /// Starts the first sub-segment of an empty queue at a time of the run, under these overrides (null:
    /// none), which must outlive the queue.
    void start(double at_s, const OverrideSchedule* overrides) {
        group_start_s_ = at_s;
        schedule_ = overrides;
    }

    /// Times the sub-segments that can be timed. The last one of the queue is not final yet, unless the queue
    /// `ended`.
    void advance(PieceQueue& queue, bool ended);
    /// Returns how many sub-segments at the front of the queue can be output: the timed ones, except the last
    /// ones of a group with unknown end, because the next group could start during them.
    std::size_t ready() const;
    /// Notes that the first `count` sub-segments have left the queue.
    void drop(std::size_t count);
    void clear();

  private:
    // Known state of the active group.
    struct Group {
        std::size_t pieces = 0;  // timed
        double duration_s = 0;
        double speed = 0;         // at the end of the last timed sub-segment
        double acceleration = 0;  // there, if an override cuts it
    };

    void look_for_end(const PieceQueue& queue);
    bool can_time(const PieceQueue& queue) const;
    Horizon horizon() const;
    void time_next(PieceQueue& queue);
    Profile profile_of(PieceQueue& queue, LimitKind& slowed_by);
    // Operator overrides (pacer_overrides.cpp).
    double share_of(const Piece& piece) const { return piece.obeyed.share(overrides_, piece.rapid); }
    Stretch stretch_of(const Piece& piece) const;
    Profile overridden_profile(PieceQueue& queue, LimitKind& slowed_by);
    Profile braking_profile(PieceQueue& queue);
    Profile curved_braking_profile(PieceQueue& queue);
    Profile cut_profile(PieceQueue& queue, const Profile& profile, double t_s);
    void split(PieceQueue& queue, double length);
    Profile pass_on(const PieceQueue& queue, LimitKind& slowed_by) const;
    Profile last_of_group(const PieceQueue& queue);
    void end_group(PieceQueue& queue, const Profile& profile);
    double overlap_s(const PieceQueue& queue, const Profile& profile) const;
    // Blends that halve the acceleration only while two sub-segments overlap (pacer_overlap.cpp).
    bool blends_late(const PieceQueue& queue, std::size_t index) const;
    Law started(const Piece& piece) const;
    double start_speed(const Law& start) const {
        return start.duration_s() > 0 ? start.end_speed() : group_.speed;
    }
    Profile to_late_blend(const PieceQueue& queue, const Profile& profile) const;
    double late_acceleration(const PieceQueue& queue) const;
    void share_end(PieceQueue& queue, double overlap_s) const;

    std::size_t depth_;
    Clock clock_;
    Planning planning_;
    const Axes* axes_;
    const OverrideSchedule* schedule_ = nullptr;
    Overrides overrides_;       // when the next sub-segment begins
    double group_start_s_ = 0;  // in run time, of the active group
    std::size_t next_ = 0;      // first sub-segment without a law
    std::size_t seen_ = 0;      // sub-segments from next_ up to here end tangent
    std::size_t final_ = 0;     // number of final sub-segments
    bool ended_ = false;        // the last final one is the last of the queue
    bool end_known_ = false;    // seen_ ends the run
    Group group_;
    double shared_before_s_ = 0;    // time by which the active group started before the previous one ended
    double late_acceleration_ = 0;  // for so long
};

}  // namespace gsim::motion::linuxcnc
