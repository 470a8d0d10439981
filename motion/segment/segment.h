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

/// See Segment::uncoordinated.
inline constexpr std::uint32_t kApart = std::uint32_t{1} << 31U;

/// Share of the path below which a joint is at standstill, except for rounding.
inline constexpr double kMinShare = 1e-9;

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

/// Joint that is not on the segment's path but moves in the same time by its own law (a rotary axis during a
/// linear move). position(t) = start + sign law(t). The law takes the full duration of the segment, or less
/// if joints move uncoordinated: then the joint waits at its end.
struct Follower {
    int joint;
    double sign;
    TimeLaw law;
    LawLimits limits;  ///< That the law keeps.
};

/// Limit that kept a move from being faster.
enum class LimitKind : std::uint8_t {
#define GSIM_LIMIT_KIND(name, number, words) name = (number),
#include "base/kinds/limit_kind.def"
};

struct LimitCause {
    LimitKind kind = LimitKind::feed;
    std::int8_t joint = -1;  ///< Joint of joint_speed, acceleration and jerk.

    bool operator==(const LimitCause&) const = default;
};

/// Deviation of a controller from the programmed path.
enum class PathDeviation : std::uint8_t {
    no,
    corner,  ///< Rounds a corner of two moves: nowhere farther off than where it passes it (deviation_mm).
    other,   ///< Other deviation: a line in place of several, more than two moves at once.
};

/// One finished part of a trajectory: a path and its time law. It starts and ends at the given joint values.
/// Joints that are neither on an arc, of position or orientation, nor followers move from start to end in
/// proportion to the leading law.
struct Segment {
    SegmentKind kind = SegmentKind::rest;
    rrs::TargetId target_id = 0;
    double start_s = 0;  ///< On the planner's clock.
    double duration_s = 0;
    /// Length of the tool path; 0 if only rotary joints move, in a dwell, and in joint motion of a machine
    /// without position joints that carry its position.
    double length_mm = 0;
    rrs::JointPos start;
    rrs::JointPos end;
    bool reaches_target = true;  ///< Ends at its target; else another segment leads on to it.
    PathDeviation path_deviation = PathDeviation::no;
    Arc arc;                                         ///< Arc of a circular segment, in the position joints.
    std::array<int, 3> position_joints{-1, -1, -1};  ///< Joints that carry x, y, z of the arc.
    TimeLaw master;           ///< Along the path: of its length in mm, or of the lead joints' norm.
    LawLimits master_limits;  ///< Limits that the law keeps, so far as they limit it; none in a dwell.
    LimitCause limited_by;
    /// Superimposed motion of the same duration, which adds its path to this one's; null in most segments
    /// (used by parabolic blends).
    std::shared_ptr<const Segment> superimposed;
    /// Path of the joints that turn the tool, run evenly with the master law; null if they move in proportion
    /// or follow.
    std::shared_ptr<const OrientationArc> orientation;
    /// Not 0 if each joint moves by its own limits, and arrives at its own time (rapids that are not
    /// interpolated): one leads, all others that move are followers. Bit j is set if the path of joint j is
    /// part of the tool path. The value of a move without such a path is only kApart.
    std::uint32_t uncoordinated = 0;
    /// Distance of the tool from the programmed corner that is rounded here. It is reported once for each
    /// such corner, by a segment of the move that begins there, and is 0 in all others.
    double deviation_mm = 0;

    std::span<const Follower> followers() const { return followers_; }
    void add_follower(int joint, double sign, const TimeLaw& law, const LawLimits& limits = {}) {
        followers_.push_back({joint, sign, law, limits});
    }
    void clear_followers() { followers_.clear(); }

    bool is_uncoordinated() const { return uncoordinated != 0; }
    /// True if the path of the joint is part of the tool path.
    bool carries_path(int joint) const;

    double end_s() const { return start_s + duration_s; }
    /// Returns the end of the segment: `end`, and what a superimposed motion adds.
    rrs::JointPos end_position() const;
    /// Returns only the positions, at `t_s` since the start of the segment; exact start and end_position() at
    /// the ends.
    rrs::JointPos position_at(double t_s) const;
    /// Returns the length of the tool path of two simultaneous motions, by chords.
    double blended_length_mm() const;
    /// Returns positions, velocities and accelerations at `t_s` since the start of the segment.
    JointState at(double t_s) const;
    /// Returns the speed of the tool along its path (mm/s) at `t_s` since the start of the segment; 0 if
    /// length_mm is 0.
    double path_speed_mm_s(double t_s) const;
    /// Returns the highest acceleration towards the centre on an arc, if it is met at peak speed; 0 on other
    /// segments. The default planner does not limit it, so that a client can warn.
    double peak_centripetal_mm_s2() const;
    /// Returns the lowest and highest value that the joint takes on the path.
    Range joint_range(int joint) const;
    /// True if a quick check proves that the joint stays within `range` on the path, for any rounding of
    /// joint_range(). Arcs are checked by their circle and their chord.
    bool is_certainly_within(const Range& range, int joint) const;

  private:
    std::vector<Follower> followers_;  // most segments have none; a slot of the queue keeps its memory
};

/// Receiver of finished segments in the order of time, each once.
class SegmentSink {
  public:
    virtual ~SegmentSink() = default;
    virtual void on_segment(const Segment& segment) = 0;
};

}  // namespace gsim::motion
