// Acceleration and deceleration of moves, as a program selects it.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

bool Simulator::has_no_jerk_limit() const {
    return std::all_of(machine_.axes.begin(), machine_.axes.end(),
                       [](const machine::Axis& axis) { return std::isinf(axis.max_jerk); });
}

/// Warns if the machine file requests S-curves and the motion has none.
void Simulator::warn_about_jerk() {
    if (!machine_.controller.limit_jerk || is_sampled()) return;
    const rrs::ControllerRules& rules = machine_.controller;
    const bool straight = rules.linuxcnc_release == rrs::LinuxcncRelease::v2_9;
    if (rules.planner == rrs::PlannerKind::linuxcnc && straight) {
        warn("limit_jerk makes no difference: the planner \"linuxcnc\" of release 2.9 has straight ramps");
    } else if (rules.planner == rrs::PlannerKind::klipper) {
        warn("limit_jerk makes no difference: the planner \"klipper\" has straight ramps");
    } else if (has_no_jerk_limit()) {
        warn("limit_jerk makes no difference: no axis of the machine has a jerk limit");
    }
}

void Simulator::set_ramps(rrs::RampMode mode) {
    if (mode == rrs::RampMode::s_curve && has_no_jerk_limit())
        warn("S-curves: no axis of the machine has a jerk limit; without one its ramps are straight");
    if (observer_ != nullptr) observer_->ramps(position_, mode);
    if (mode != rrs::RampMode::machine && !supports_ramps()) return;
    change_ramps([mode](motion::ProgrammedRamps& ramps) { ramps.mode = mode; });
}

void Simulator::set_ramp_limit(rrs::RampLimit limit, int axis, double value) {
    const bool rotary = machine_.axes[static_cast<std::size_t>(axis)].kind == machine::AxisKind::rotary;
    const double in_joint_units = value * (rotary ? kRadPerDeg : 1.0);
    if (observer_ != nullptr)
        observer_->ramp_limit(position_, limit, machine_.axes[static_cast<std::size_t>(axis)], value);
    if (!supports_ramps()) return;
    change_ramps([&](motion::ProgrammedRamps& ramps) { ramps.of(limit)[axis] = in_joint_units; });
}

void Simulator::reset_ramp_limits() {
    if (observer_ != nullptr) observer_->no_ramp_limits(position_);
    if (!supports_ramps()) return;
    change_ramps([this](motion::ProgrammedRamps& ramps) {
        const rrs::RampMode mode = ramps.mode;
        ramps = motion::ProgrammedRamps(setup_.joint_count());
        ramps.mode = mode;
    });
}

void Simulator::set_path_limits(const ProgrammedPathLimits& limits) {
    motion::PlannerSetup changed = path_limits_ ? *path_limits_ : setup_;
    const auto set = [](double& value, const std::optional<double>& to) { value = to.value_or(value); };
    set(changed.path.max_feed_mm_s, limits.speed_mm_s);
    set(changed.path.max_acceleration_mm_s2, limits.acceleration_mm_s2);
    set(changed.controller.square_corner_velocity_mm_s, limits.square_corner_velocity_mm_s);
    set(changed.controller.minimum_cruise_ratio, limits.minimum_cruise_ratio);
    path_limits_ = std::make_shared<const motion::PlannerSetup>(std::move(changed));
    if (observer_ != nullptr) observer_->on_unrecordable_motion("the program changes limits of its path");
}

bool Simulator::supports_ramps() {
    const motion::PlanResult checked = motion_->check_ramps();
    if (!checked) warn(checked.error().message);
    return checked.has_value();
}

template <typename Change>
void Simulator::change_ramps(const Change& change) {
    motion::ProgrammedRamps ramps = ramps_ ? *ramps_ : motion::ProgrammedRamps(setup_.joint_count());
    change(ramps);
    ramps_ = std::make_shared<const motion::ProgrammedRamps>(std::move(ramps));
}

}  // namespace gsim::simulation
