#pragma once

#include <optional>
#include <span>
#include <vector>

#include "machine/model/machine.h"
#include "runtime/outputs/run_output.h"

namespace gsim::simulation {

/// Step that takes an axis past its range.
struct RangeExcess {
    double t_s = 0;  ///< When the step ends.
    MoveInfo move;   ///< Move of the step.
    std::size_t axis = 0;
    double value = 0;  ///< Farthest axis position from there on, mm or deg, as `limit`.
    double limit = 0;
};

/// Monitor of the axis positions in the steps of a controller module. Its targets are known to be within the
/// ranges, but not its steps. Half a step of an axis beyond is not past its range, because controllers round
/// to steps.
class StepRangeMonitor final : public RunOutput {
  public:
    /// `machine` must outlive this.
    explicit StepRangeMonitor(const machine::Machine& machine) : machine_(machine) {}

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;

    /// Returns them by time, the first of each axis.
    std::span<const RangeExcess> found() const { return found_; }

  private:
    void check_axis_range(std::size_t axis, double value, double t_s, const MoveInfo& info);

    const machine::Machine& machine_;
    std::vector<RangeExcess> found_;
};

}  // namespace gsim::simulation
