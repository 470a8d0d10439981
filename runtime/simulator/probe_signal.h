#pragma once

#include <functional>
#include <optional>

#include "collision/monitor/touch_search.h"
#include "motion/segment/segment.h"

namespace gsim::simulation {

/// The signal that ends a probing move.
class ProbeSignal {
  public:
    virtual ~ProbeSignal() = default;
    /// Whether it is there already with the joints (mm or rad) at these values.
    virtual bool is_there(const rrs::JointPos& joints) const = 0;
    /// When it first comes in a segment, in s since its start. Segments are asked in the order of time, from
    /// the first of the move on, up to the one in which it comes.
    virtual std::optional<double> comes_s(const motion::Segment& segment) = 0;
};

/// Comes where a quantity that grows along the way is 0: the distance beyond a plane or a point of the way.
class MarkSignal final : public ProbeSignal {
  public:
    using Beyond = std::function<double(const rrs::JointPos&)>;  ///< mm or deg

    explicit MarkSignal(Beyond beyond) : beyond_(std::move(beyond)) {}
    bool is_there(const rrs::JointPos& joints) const override { return beyond_(joints) >= 0; }
    std::optional<double> comes_s(const motion::Segment& segment) override;

  private:
    Beyond beyond_;
};

/// Comes where the probe touches bodies of a cell, or ceases to.
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
