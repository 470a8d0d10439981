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

/// Confidence of the time of a run on a machine with parameters that were fitted to recorded runs. The same
/// moves are planned in a comparison, once for each parameter with a value that is 1 % off. The covariance of
/// the parameters becomes a spread of the time (first order, of logarithms: Gaussian propagation).
class ConfidenceIntervalMonitor final : public MotionObserver {
  public:
    /// `machine` has a calibration.
    explicit ConfidenceIntervalMonitor(const machine::Machine& machine);

    void on_start_position(const rrs::JointPos& joints) override;
    void on_request(const MotionRequest& request) override;
    void on_unrecordable(std::string_view reason) override;
    void ended() override;

    /// Returns the interval of the full time of a run that has ended, including what the fit has left of the
    /// recorded times. Nullopt if error() gives a reason.
    std::optional<TimeInterval> interval(double time_s) const;
    const std::string& error() const { return error_; }

  private:
    /// Machine with one parameter that is off.
    struct PerturbedMachine {
        std::unique_ptr<motion::Planner> planner;
        machine::WordTimes times;
        double log_step = 0;  ///< Step of the parameter's logarithm.
    };

    double log_variance(double time_s) const;

    machine::Calibration calibration_;
    std::unique_ptr<motion::SegmentSink> null_sink_;
    std::vector<PerturbedMachine> perturbed_machines_;
    std::string error_;
};

}  // namespace gsim::simulation
