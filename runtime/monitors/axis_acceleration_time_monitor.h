#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "machine/model/machine.h"
#include "motion/planner/planner.h"
#include "runtime/motion_sources/motion_observer.h"

namespace gsim::simulation {

/// Duration of the moves of a run with the accelerations of the axes, if the peaks of its motors limit them.
/// They are planned in a comparison.
class AxisAccelerationTimeMonitor final : public MotionObserver {
  public:
    explicit AxisAccelerationTimeMonitor(const machine::Machine& machine);

    void on_start_position(const rrs::JointPos& joints) override;
    void on_request(const MotionRequest& request) override;
    void on_unrecordable(std::string_view reason) override;
    void ended() override;

    /// Returns the time of a run that has ended; nullopt if error() gives a reason.
    std::optional<double> time_s() const;
    const std::string& error() const { return error_; }

  private:
    std::unique_ptr<motion::SegmentSink> null_sink_;
    machine::WordTimes word_times_;
    motion::Planner planner_;
    std::string error_;
};

}  // namespace gsim::simulation
