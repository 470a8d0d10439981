#include "runtime/monitors/interval_watch.h"

#include <algorithm>
#include <cmath>

#include "machine/model/figure.h"
#include "machine/model/torque_limit.h"
#include "runtime/motion_sources/motion_replay.h"
#include "runtime/motion_sources/time_alone.h"
#include "runtime/simulator/setup_of_machine.h"

namespace gsim::simulation {

namespace {

constexpr double kStep = 0.01;           // of a figure
constexpr double kPercent95 = 1.959964;  // standard deviations on each side of 95 in 100

/// Lowers the value, because shares are at most 1; raises it if less than 1 would have another meaning.
double value_beside(const machine::Figure& figure, double value) {
    const bool would_turn = figure.key == "centripetal_share" && value >= 1 && value * (1 - kStep) < 1;
    return value * (would_turn ? 1 + kStep : 1 - kStep);
}

}  // namespace

IntervalWatch::IntervalWatch(const machine::Machine& machine)
    : calibration_(*machine.calibration), nowhere_(std::make_unique<TimeAlone>()) {
    if (machine::is_torque_limited(machine)) {
        untold("torques limit its accelerations");
        return;
    }
    for (const machine::Figure& figure : calibration_.figures) {
        const double value = machine::value_of(figure, machine).value_or(0);
        if (!(value > 0) || !std::isfinite(value)) {
            untold(machine::name_of(figure) + " is none");
            return;
        }
        const double other = value_beside(figure, value);
        machine::Machine off = machine;
        machine::set_value(figure, other, off);
        beside_.push_back({std::make_unique<motion::Planner>(setup_of_machine(off), nowhere_.get()),
                           off.times, std::log(other / value)});
    }
}

void IntervalWatch::untold(std::string_view why) {
    if (why_not_.empty()) why_not_ = why;
    beside_.clear();
}

void IntervalWatch::stands_at(const rrs::JointPos& joints) {
    for (const Beside& beside : beside_) {
        if (const auto stands = beside.planner->stand_at({joints, std::nullopt}); !stands)
            return untold(stands.error().message);
    }
}

void IntervalWatch::asked(const MotionAsk& ask) {
    for (const Beside& beside : beside_) {
        if (const auto put = ask_again(ask, beside.times, *beside.planner); !put)
            return untold(put.error().message);
    }
}

void IntervalWatch::ended() {
    for (const Beside& beside : beside_) {
        beside.planner->come_to_last_rest();
        beside.planner->flush();
    }
}

double IntervalWatch::log_variance(double time_s) const {
    std::vector<double> slopes;
    for (const Beside& beside : beside_)
        slopes.push_back(std::log(beside.planner->time_s() / time_s) / beside.log_step);
    constexpr double kPercent2 = 1e-4;
    double variance = calibration_.left_percent * calibration_.left_percent * kPercent2;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        for (std::size_t k = 0; k < slopes.size(); ++k)
            variance += slopes[i] * slopes[k] * calibration_.covariance_percent2[i][k] * kPercent2;
    }
    return std::max(variance, 0.0);
}

std::optional<TimeInterval> IntervalWatch::interval(double time_s) const {
    if (!why_not_.empty() || !(time_s > 0)) return std::nullopt;
    const double spread = kPercent95 * std::sqrt(log_variance(time_s));
    return TimeInterval{time_s * std::exp(-spread), time_s * std::exp(spread)};
}

}  // namespace gsim::simulation
