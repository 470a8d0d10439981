#pragma once

#include <functional>
#include <optional>

#include "collision/monitor/touch_search.h"
#include "motion/segment/segment.h"

namespace gsim::simulation {

/// Signal that ends a probing move.
class ProbeSignal {
  public:
    virtual ~ProbeSignal() = default;
    /// Returns true if the signal is already on with the joints (mm or rad) at these values.
    virtual bool is_there(const rrs::JointPos& joints) const = 0;
    /// Returns the first time of the signal in a segment, in s since its start. Segments must be passed in
    /// the order of time, from the first of the move on, up to the one with the signal.
    virtual std::optional<double> comes_s(const motion::Segment& segment) = 0;
};

/// Signal at the point where a quantity that grows along the path is 0: the distance beyond a plane or a
/// point of the path.
class MarkSignal final : public ProbeSignal {
  public:
    using Beyond = std::function<double(const rrs::JointPos&)>;  ///< mm or deg

    explicit MarkSignal(Beyond beyond) : beyond_(std::move(beyond)) {}
    bool is_there(const rrs::JointPos& joints) const override { return beyond_(joints) >= 0; }
    std::optional<double> comes_s(const motion::Segment& segment) override;

  private:
    Beyond beyond_;
};

/// Signal when the probe begins to touch bodies of a cell, or ceases to.
class TouchSignal final : public ProbeSignal {
  public:
    TouchSignal(cell::TouchSearch search, bool away) : search_(std::move(search)), away_(away) {}
    bool is_there(const rrs::JointPos& joints) const override { return search_.touches(joints) != away_; }
    std::optional<double> comes_s(const motion::Segment& segment) override {
        return away_ ? search_.first_release_s(segment) : search_.first_touch_s(segment);
    }

  private:
    cell::TouchSearch search_;
    bool away_;
};

}  // namespace gsim::simulation
