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
    virtual bool is_active(const rrs::JointPos& joints) const = 0;
    /// Returns the first time of the signal in a segment, in s since its start. Segments must be passed in
    /// the order of time, from the first of the move on, up to the one with the signal.
    virtual std::optional<double> activation_s(const motion::Segment& segment) = 0;
};

/// Signal at the point where a quantity that grows along the path is 0: the distance beyond a plane or a
/// point of the path.
class ThresholdSignal final : public ProbeSignal {
  public:
    using DistanceFunction = std::function<double(const rrs::JointPos&)>;  ///< mm or deg

    explicit ThresholdSignal(DistanceFunction distance) : distance_(std::move(distance)) {}
    bool is_active(const rrs::JointPos& joints) const override { return distance_(joints) >= 0; }
    std::optional<double> activation_s(const motion::Segment& segment) override;

  private:
    DistanceFunction distance_;
};

/// Signal when the probe begins to touch bodies of a cell, or ceases to.
class ContactSignal final : public ProbeSignal {
  public:
    ContactSignal(cell::TouchSearch search, bool away) : search_(std::move(search)), away_(away) {}
    bool is_active(const rrs::JointPos& joints) const override { return search_.touches(joints) != away_; }
    std::optional<double> activation_s(const motion::Segment& segment) override {
        return away_ ? search_.first_release_s(segment) : search_.first_touch_s(segment);
    }

  private:
    cell::TouchSearch search_;
    bool away_;
};

}  // namespace gsim::simulation
