#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "controller/services/types.h"
#include "motion/path/arc.h"
#include "motion/path/orientation_arc.h"
#include "motion/profile/time_law.h"

namespace gsim::motion {

/// See Segment::apart.
inline constexpr std::uint32_t kApart = std::uint32_t{1} << 31U;

/// A joint that goes by less of the way than this stands still, but for rounding.
inline constexpr double kNoShare = 1e-9;

enum class SegmentKind {
#define GSIM_SEGMENT_KIND(name, number, constant) name = (number),
#include "base/kinds/segment_kind.def"
};

/// Joint positions, velocities and accelerations at an instant (mm or rad, s).
struct JointState {
    rrs::JointPos position;
    rrs::JointPos velocity;
    rrs::JointPos acceleration;
};

/// A joint that is not on the segment's path but moves in the same time by a law of its own (a rotary axis
/// beside a linear move). position(t) = start + sign law(t). The law takes the whole duration of the segment,
/// or less where joints go apart: then the joint waits at its end.
struct Follower {
    int joint;
    double sign;
    TimeLaw law;
    LawLimits limits;  ///< That the law keeps.
};

/// What kept a move from being faster.
enum class LimitKind : std::uint8_t {
#define GSIM_LIMIT_KIND(name, number, words) name = (number),
#include "base/kinds/limit_kind.def"
};

struct LimitedBy {
    LimitKind kind = LimitKind::feed;
    std::int8_t joint = -1;  ///< Of joint_speed, acceleration and jerk.

    bool operator==(const LimitedBy&) const = default;
};

/// Whether a controller leaves the programmed way.
enum class OffWay : std::uint8_t {
    no,
    corner,  ///< Rounds a corner of two moves: nowhere farther off than where it passes it (deviation_mm).
    yes,     ///< In another way: a line in place of several, more than two moves at once.
};

/// One finished piece of trajectory: a path and its time law. Starts and ends at the given joint values.
/// Joints that are neither on an arc, of position or orientation, nor followers go from start to end in
/// proportion to the lead law.
struct Segment {
    SegmentKind kind = SegmentKind::rest;
    rrs::TargetId target_id = 0;
    double start_s = 0;  ///< On the planner's clock.
    double duration_s = 0;
    /// Of the tool's path; 0 where only rotary joints move, in a rest, and in joint motion of a machine whose
    /// position is not carried by position joints.
    double length_mm = 0;
    rrs::JointPos start;
    rrs::JointPos end;
    bool reaches_target = true;  ///< Ends at its target; else another segment leads on to it.
    OffWay off_way = OffWay::no;
    Arc arc;                                         ///< Of a circular segment, in the position joints.
    std::array<int, 3> position_joints{-1, -1, -1};  ///< Joints that carry x, y, z of the arc.
    TimeLaw lead;           ///< Along the path: of its length in mm, or of the lead joints' norm.
    LawLimits lead_limits;  ///< That the lead keeps, so far as they limit it; none in a rest.
    LimitedBy limited_by;
    /// A motion at the same time, as long as this one, whose way adds to this one's; null in most (parabolic
    /// blends).
    std::shared_ptr<const Segment> beside;
    /// The way of the joints that turn the tool, gone through evenly with the lead; null where they go in
    /// proportion or follow.
    std::shared_ptr<const OrientationArc> orientation;
    /// Not 0: each joint goes by its own limits, and arrives at a time of its own (rapids that are not
    /// interpolated): one leads, all others that move are followers. Bit j is set where the way of joint j is
    /// part of the tool's path; that of a move without such a way is kApart alone.
    std::uint32_t apart = 0;
    /// How far the tool passes from the programmed corner that is rounded here; told once for each such
    /// corner, by a segment of the move that begins there. 0 in all others.
    double deviation_mm = 0;

    std::span<const Follower> followers() const { return followers_; }
    void add_follower(int joint, double sign, const TimeLaw& law, const LawLimits& limits = {}) {
        followers_.push_back({joint, sign, law, limits});
    }
    void clear_followers() { followers_.clear(); }

    bool joints_go_apart() const { return apart != 0; }
    /// Whether the way of the joint is part of the tool's path.
    bool carries_path(int joint) const;

    double end_s() const { return start_s + duration_s; }
    /// Where the segment leads: `end`, and what a motion beside it adds.
    rrs::JointPos end_position() const;
    /// Positions only, at `t_s` since the start of the segment; exact start and end_position() at the ends.
    rrs::JointPos position_at(double t_s) const;
    /// The length of the tool's way where two motions go on at once, by chords.
    double blended_length_mm() const;
    /// Positions, velocities and accelerations at `t_s` since the start of the segment.
    JointState at(double t_s) const;
    /// Speed of the tool along its path (mm/s) at `t_s` since the start of the segment; 0 where length_mm is
    /// 0.
    double path_speed_mm_s(double t_s) const;
    /// The highest acceleration towards the centre on an arc, if it is met at peak speed; 0 on other
    /// segments. The default planner does not limit it, so that a client can warn.
    double peak_centripetal_mm_s2() const;
    /// The lowest and highest value that the joint takes on the way.
    Range joint_range(int joint) const;
    /// True where it is sure without a closer look that the joint stays within `range` on the way, whatever
    /// rounding does to joint_range(); told for arcs by their circle and their chord.
    bool surely_within(const Range& range, int joint) const;

  private:
    std::vector<Follower> followers_;  // most segments have none; a slot of the queue keeps its memory
};

/// Takes finished segments in the order of time, each once.
class SegmentSink {
  public:
    virtual ~SegmentSink() = default;
    virtual void take(const Segment& segment) = 0;
};

}  // namespace gsim::motion
