#include "runtime/monitors/confidence_interval_monitor.h"

#include <algorithm>
#include <cmath>

#include "machine/model/machine_parameter.h"
#include "machine/model/torque_limit.h"
#include "runtime/motion_sources/motion_replay.h"
#include "runtime/motion_sources/null_segment_sink.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::simulation {

namespace {

constexpr double kStep = 0.01;                  // of a figure
constexpr double kNormalQuantile95 = 1.959964;  // standard deviations on each side of 95 in 100

/// Lowers the value, because shares are at most 1; raises it if less than 1 would have another meaning.
double perturbed_value(const machine::MachineParameter& parameter_id, double value) {
    const bool crosses_one = parameter_id.key == "centripetal_share" && value >= 1 && value * (1 - kStep) < 1;
    return value * (crosses_one ? 1 + kStep : 1 - kStep);
}

}  // namespace

ConfidenceIntervalMonitor::ConfidenceIntervalMonitor(const machine::Machine& machine)
    : calibration_(*machine.calibration), null_sink_(std::make_unique<NullSegmentSink>()) {
    if (machine::is_torque_limited(machine)) {
        on_unrecordable("torques limit its accelerations");
        return;
    }
    for (const machine::MachineParameter& parameter_id : calibration_.parameters) {
        const double value = machine::parameter_value(parameter_id, machine).value_or(0);
        if (!(value > 0) || !std::isfinite(value)) {
            on_unrecordable(machine::parameter_name(parameter_id) + " is not a positive number");
            return;
        }
        const double other = perturbed_value(parameter_id, value);
        machine::Machine perturbed_machine = machine;
        machine::set_value(parameter_id, other, perturbed_machine);
        perturbed_machines_.push_back(
            {std::make_unique<motion::Planner>(make_planner_setup(perturbed_machine), null_sink_.get()),
             perturbed_machine.times, std::log(other / value)});
    }
}

void ConfidenceIntervalMonitor::on_unrecordable(std::string_view reason) {
    if (error_.empty()) error_ = reason;
    perturbed_machines_.clear();
}

void ConfidenceIntervalMonitor::on_start_position(const rrs::JointPos& joints) {
    for (const PerturbedMachine& comparison : perturbed_machines_) {
        if (const auto started = comparison.planner->set_position({joints, std::nullopt}); !started)
            return on_unrecordable(started.error().message);
    }
}

void ConfidenceIntervalMonitor::on_request(const MotionRequest& request) {
    for (const PerturbedMachine& comparison : perturbed_machines_) {
        if (const auto enqueue = replay_request(request, comparison.times, *comparison.planner); !enqueue)
            return on_unrecordable(enqueue.error().message);
    }
}

void ConfidenceIntervalMonitor::ended() {
    for (const PerturbedMachine& comparison : perturbed_machines_) {
        comparison.planner->dwells().plan_to_final_standstill();
        comparison.planner->flush();
    }
}

double ConfidenceIntervalMonitor::log_variance(double time_s) const {
    std::vector<double> slopes;
    for (const PerturbedMachine& comparison : perturbed_machines_)
        slopes.push_back(std::log(comparison.planner->time_s() / time_s) / comparison.log_step);
    constexpr double kPercentSquared = 1e-4;
    double variance = calibration_.residual_percent * calibration_.residual_percent * kPercentSquared;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        for (std::size_t k = 0; k < slopes.size(); ++k)
            variance += slopes[i] * slopes[k] * calibration_.covariance_percent2[i][k] * kPercentSquared;
    }
    return std::max(variance, 0.0);
}

std::optional<TimeInterval> ConfidenceIntervalMonitor::interval(double time_s) const {
    if (!error_.empty() || !(time_s > 0)) return std::nullopt;
    const double log_half_width = kNormalQuantile95 * std::sqrt(log_variance(time_s));
    return TimeInterval{time_s * std::exp(-log_half_width), time_s * std::exp(log_half_width)};
}

}  // namespace gsim::simulation
