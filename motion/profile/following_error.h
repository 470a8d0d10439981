#pragma once

#include "motion/planner/motion_model.h"

namespace gsim::motion {

/// The lag of a position loop of first order behind its set point, e' = v - gain e, after a law that it began
/// with `lag` (mm or rad, as the law). `gain_1_s` > 0.
double lag_after(const TimeLaw& law, double lag, double gain_1_s);

/// The output of a model that follows how far a machine lags behind the segments that pass through.
///
/// The lag is that along the way. Of joints it is their share of it, exactly on straight ways; behind corners
/// and curves, where what is left of one direction is counted for the other, no joint's is more than that.
class FollowingError final : public SegmentOutput {
  public:
    /// Both must outlive this. Without a gain nothing lags.
    FollowingError(const rrs::ControllerRules& controller, SegmentOutput& output)
        : controller_(controller), output_(output) {}

    Segment& begin(rrs::TargetId id) override;
    void finish() override;
    double time_s() const override { return output_.time_s(); }
    void clear() { lag_ = 0; }

    /// Behind the last segment, mm or rad as its way.
    double lag() const { return lag_; }

  private:
    const rrs::ControllerRules& controller_;
    SegmentOutput& output_;
    Segment* open_ = nullptr;
    double lag_ = 0;
    double end_s_ = 0;  ///< Of the last segment.
};

}  // namespace gsim::motion
