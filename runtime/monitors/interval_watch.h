#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/model/machine.h"
#include "motion/planner/planner.h"
#include "runtime/motion_sources/motion_observer.h"
#include "runtime/report/report.h"

namespace gsim::simulation {

/// How sure the time of a run is on a machine whose figures were fitted to recorded runs: the same moves are
/// planned beside, once for each figure with a value that is 1 % off, and the covariance of the figures
/// becomes a spread of the time (first order, of logarithms: Gaussian propagation).
class IntervalWatch final : public MotionObserver {
  public:
    /// `machine` has a calibration.
    explicit IntervalWatch(const machine::Machine& machine);

    void stands_at(const rrs::JointPos& joints) override;
    void asked(const MotionAsk& ask) override;
    void untold(std::string_view why) override;
    void ended() override;

    /// Of the whole time of a run that has ended, with what the fit has left of the recorded times. Nothing
    /// where why_not() tells why.
    std::optional<TimeInterval> interval(double time_s) const;
    const std::string& why_not() const { return why_not_; }

  private:
    /// The machine with one figure that is off.
    struct Beside {
        std::unique_ptr<motion::Planner> planner;
        machine::WordTimes times;
        double log_step = 0;  ///< Of the figure's logarithm.
    };

    double log_variance(double time_s) const;

    machine::Calibration calibration_;
    std::unique_ptr<motion::SegmentSink> nowhere_;
    std::vector<Beside> beside_;
    std::string why_not_;
};

}  // namespace gsim::simulation
