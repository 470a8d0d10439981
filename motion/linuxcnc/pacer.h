#pragma once

#include <cstddef>
#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/held_piece.h"
#include "motion/linuxcnc/look_ahead.h"
#include "motion/linuxcnc/profile.h"

namespace gsim::motion::linuxcnc {

/// Gives the pieces of a queue their time laws, in order, as soon as enough of what follows is known.
///
/// Pieces that meet at speed form a group, which starts and ends at rest and takes whole periods. Where its
/// end is a parabolic blend the next group starts before it is at rest.
class Pacer {
  public:
    /// `axes` must outlive it.
    Pacer(std::size_t depth, const Clock& clock, const Planning& planning, const Axes& axes)
        : depth_(depth), clock_(clock), planning_(planning), axes_(&axes) {}

    /// The first piece of an empty queue begins at a time of the run, under these overrides (null: none),
    /// which must outlive the queue.
    void start(double at_s, const OverrideSchedule* overrides) {
        group_start_s_ = at_s;
        schedule_ = overrides;
    }

    /// Times what can be timed. The last piece of the queue is not final yet, unless the queue `ended`.
    void advance(PieceQueue& queue, bool ended);
    /// How many pieces at the front of the queue can be put out: timed ones, but for the last of a group
    /// whose end is not known, with which the next group could start.
    std::size_t ready() const;
    /// The first `count` pieces have left the queue.
    void drop(std::size_t count);
    void clear();

  private:
    // What is known of the group under way.
    struct Group {
        std::size_t pieces = 0;  // timed
        double duration_s = 0;
        double speed = 0;         // at the end of the last timed piece
        double acceleration = 0;  // there, where an override cuts it
    };

    void look_for_end(const PieceQueue& queue);
    bool can_time(const PieceQueue& queue) const;
    Horizon horizon() const;
    void time_next(PieceQueue& queue);
    Profile profile_of(PieceQueue& queue, LimitKind& slowed_by);
    // What the operator turns (pacer_overrides.cpp).
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
    // Where the acceleration is halved only as long as two pieces overlap (pacer_overlap.cpp).
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
    Overrides overrides_;       // as the next piece begins
    double group_start_s_ = 0;  // of the run, of the group under way
    std::size_t next_ = 0;      // first piece without a law
    std::size_t seen_ = 0;      // pieces up to here, from next_ on, end tangent
    std::size_t final_ = 0;     // number of final pieces
    bool ended_ = false;        // the last final piece is the last of the queue
    bool end_known_ = false;    // seen_ ends the run
    Group group_;
    double shared_before_s_ = 0;    // the group under way started so long before the end of the one before
    double late_acceleration_ = 0;  // for so long
};

}  // namespace gsim::motion::linuxcnc
