#pragma once

#include "collision/cell/link_frames.h"
#include "collision/pairs/motion_bound.h"

namespace gsim::cell {

/// Part of a motion's time, in s since its start: the link frames at both ends, and their motion.
struct MotionPart {
    double from_s;
    double to_s;
    LinkFrames from;
    LinkFrames to;
    ChainMotion chain;

    double middle_s() const { return from_s + (to_s - from_s) / 2; }
};

/// Motion of the links of a machine, or of several in one world, for a time.
class LinkMotion {
  public:
    virtual ~LinkMotion() = default;

    virtual LinkFrames links_at(double t_s) const = 0;
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
    virtual MotionPart part(double from_s, const LinkFrames& from, double to_s,
                            const LinkFrames& to) const = 0;
};

}  // namespace gsim::cell
