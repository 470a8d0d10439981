#pragma once

#include "collision/cell/frame_trajectory.h"
#include "collision/pairs/link_motion.h"

namespace gsim::cell {

/// Motion of a machine's links in a segment, in s since its start, and of links that move independently
/// meanwhile. All arguments must outlive this.
class SegmentMotion final : public LinkMotion {
  public:
    SegmentMotion(const kinematics::Kinematics& kinematics, const motion::Segment& segment,
                  std::span<const MovingLink> moving_links = {})
        : kinematics_(kinematics), segment_(segment), moving_links_(moving_links) {}

    const motion::Segment& segment() const { return segment_; }
    LinkFrames links_at(double t_s) const override;
    MotionPart full_motion() const { return between(0, segment_.duration_s); }

  private:
    MotionPart part(double from_s, const LinkFrames& from, double to_s, const LinkFrames& to) const override;

    const kinematics::Kinematics& kinematics_;
    const motion::Segment& segment_;
    std::span<const MovingLink> moving_links_;
};

}  // namespace gsim::cell
