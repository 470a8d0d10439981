#pragma once

#include "runtime/cell/carrier.h"
#include "runtime/cell/link_frames.h"
#include "runtime/cell/motion_bound.h"

namespace gsim::cell {

/// A part of a segment's time, in s since its start: where the links are at both ends, and how they go.
struct MotionPart {
    double from_s;
    double to_s;
    LinkFrames from;
    LinkFrames to;
    ChainMotion chain;

    double middle_s() const { return from_s + (to_s - from_s) / 2; }
};

/// The motion of a machine's links in a segment, and of links that go by themselves meanwhile. All must
/// outlive this.
class SegmentMotion {
  public:
    SegmentMotion(const kinematics::Kinematics& kinematics, const motion::Segment& segment,
                  std::span<const DriftingLink> drifting = {})
        : kinematics_(kinematics), segment_(segment), drifting_(drifting) {}

    const motion::Segment& segment() const { return segment_; }
    LinkFrames links_at(double t_s) const;
    MotionPart whole() const { return between(0, segment_.duration_s); }
    MotionPart between(double from_s, double to_s) const {
        return part(from_s, links_at(from_s), to_s, links_at(to_s));
    }
    MotionPart first_half(const MotionPart& of, const LinkFrames& middle) const {
        return part(of.from_s, of.from, of.middle_s(), middle);
    }
    MotionPart second_half(const MotionPart& of, const LinkFrames& middle) const {
        return part(of.middle_s(), middle, of.to_s, of.to);
    }

  private:
    MotionPart part(double from_s, const LinkFrames& from, double to_s, const LinkFrames& to) const;

    const kinematics::Kinematics& kinematics_;
    const motion::Segment& segment_;
    std::span<const DriftingLink> drifting_;
};

}  // namespace gsim::cell
