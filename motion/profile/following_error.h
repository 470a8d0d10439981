#pragma once

#include "motion/planner/motion_model.h"

namespace gsim::motion {

/// Returns the lag of a first-order position loop relative to its set point, e' = v - gain e, after a law
/// that it began with `lag` (mm or rad, as the law). `gain_1_s` > 0.
double lag_after(const TimeLaw& law, double lag, double gain_1_s);

/// Output of a model that tracks how far a machine lags behind the segments that pass through.
///
/// The lag is that along the path. The lag of a joint is its share of that, exactly on straight paths. The
/// remainder of one direction counts for the other after corners and curves, and no joint's lag is more than
/// that.
class FollowingError final : public SegmentOutput {
  public:
    /// Both must outlive this. The lag is 0 without a gain.
    FollowingError(const rrs::PositionLoopRules& position_loop, SegmentOutput& output)
        : position_loop_(position_loop), output_(output) {}

    Segment& begin(rrs::TargetId id) override;
    void finish() override;
    double time_s() const override { return output_.time_s(); }
    void clear() { lag_ = 0; }

    /// Returns the lag after the last segment, mm or rad as its path.
    double lag() const { return lag_; }

  private:
    const rrs::PositionLoopRules& position_loop_;
    SegmentOutput& output_;
    Segment* open_ = nullptr;
    double lag_ = 0;
    double end_s_ = 0;  ///< End of the last segment.
};

}  // namespace gsim::motion
