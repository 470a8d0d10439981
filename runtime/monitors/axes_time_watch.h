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
class AxesTimeWatch final : public MotionObserver {
  public:
    explicit AxesTimeWatch(const machine::Machine& machine);

    void stands_at(const rrs::JointPos& joints) override;
    void asked(const MotionAsk& ask) override;
    void untold(std::string_view why) override;
    void ended() override;

    /// Returns the time of a run that has ended; nullopt if why_not() gives a reason.
    std::optional<double> time_s() const;
    const std::string& why_not() const { return why_not_; }

  private:
    std::unique_ptr<motion::SegmentSink> nowhere_;
    machine::WordTimes times_;
    motion::Planner planner_;
    std::string why_not_;
};

}  // namespace gsim::simulation
