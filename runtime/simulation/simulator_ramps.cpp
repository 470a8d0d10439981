// How moves speed up and slow down, as a program selects it.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

bool Simulator::limits_no_jerk() const {
    return std::all_of(machine_.axes.begin(), machine_.axes.end(),
                       [](const machine::Axis& axis) { return std::isinf(axis.max_jerk); });
}

/// A machine file that asks for S-curves and gets none.
void Simulator::warn_of_jerk() {
    if (!machine_.controller.limit_jerk || sampled()) return;
    if (machine_.controller.planner == rrs::PlannerKind::linuxcnc) {
        warn("limit_jerk makes no difference: the planner \"linuxcnc\" has straight ramps");
    } else if (limits_no_jerk()) {
        warn("limit_jerk makes no difference: no axis of the machine has a jerk limit");
    }
}

void Simulator::set_ramps(rrs::RampMode mode) {
    if (mode == rrs::RampMode::s_curve && limits_no_jerk())
        warn("S-curves: no axis of the machine has a jerk limit; without one its ramps are straight");
    if (observer_ != nullptr) observer_->ramps(position_, mode);
    warn_if_refused(shell_.SetRampMode(mode));
}

void Simulator::set_ramp_limit(rrs::RampLimit limit, int axis, double value) {
    const bool rotary = machine_.axes[static_cast<std::size_t>(axis)].kind == machine::AxisKind::rotary;
    const double in_joint_units = value * (rotary ? kRadPerDeg : 1.0);
    if (observer_ != nullptr)
        observer_->ramp_limit(position_, limit, machine_.axes[static_cast<std::size_t>(axis)], value);
    warn_if_refused(shell_.SetJointRampLimits(limit, {&axis, 1}, {&in_joint_units, 1}));
}

void Simulator::reset_ramp_limits() {
    if (observer_ != nullptr) observer_->no_ramp_limits(position_);
    const std::vector<double> none(machine_.axes.size(), motion::kUnlimited);
    for (const auto limit :
         {rrs::RampLimit::acceleration, rrs::RampLimit::deceleration, rrs::RampLimit::jerk})
        warn_if_refused(shell_.SetJointRampLimits(limit, {}, none));
}

void Simulator::warn_if_refused(rrs::Status status) {
    if (static_cast<int>(status) < 0) warn(motion_->last_error().message);
}

}  // namespace gsim::simulation
