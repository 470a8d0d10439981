#include "runtime/simulator/program/ramp_settings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"

namespace gsim::simulation {

bool RampSettings::has_no_jerk_limit() const {
    return std::all_of(machine_.axes.begin(), machine_.axes.end(),
                       [](const machine::Axis& axis) { return std::isinf(axis.max_jerk); });
}

void RampSettings::warn_about_jerk() {
    if (!machine_.controller.ramps.limit_jerk || motion_.source().is_sampled()) return;
    const rrs::ControllerRules& rules = machine_.controller;
    const rrs::PlannerCapabilities& planner = rules.capabilities();
    if (!rules.has_s_curves()) {
        warnings_.add(fmt::format(
            "limit_jerk has no effect: the planner \"{}\"{} has ramps with constant acceleration",
            planner.name, planner.s_curves == rrs::SCurves::release_2_10 ? " of release 2.9" : ""));
    } else if (has_no_jerk_limit()) {
        warnings_.add("limit_jerk has no effect: no axis of the machine has a jerk limit");
    }
}

void RampSettings::set_mode(rrs::RampMode mode) {
    if (mode == rrs::RampMode::s_curve && has_no_jerk_limit()) {
        warnings_.add(
            "S-curves: no axis of the machine has a jerk limit; without one its ramps have constant "
            "acceleration");
    }
    notifier_.notify([&](ProgramObserver& observer) { observer.ramps(position_.axes(), mode); });
    if (mode != rrs::RampMode::machine && !are_supported()) return;
    change([mode](motion::ProgrammedRamps& ramps) { ramps.mode = mode; });
}

void RampSettings::set_limit(rrs::RampLimit limit, int axis, double value) {
    const machine::Axis& limited = machine_.axes[static_cast<std::size_t>(axis)];
    const bool rotary = limited.kind == machine::AxisKind::rotary;
    const double in_joint_units = value * (rotary ? kRadPerDeg : 1.0);
    notifier_.notify(
        [&](ProgramObserver& observer) { observer.ramp_limit(position_.axes(), limit, limited, value); });
    if (!are_supported()) return;
    change([&](motion::ProgrammedRamps& ramps) { ramps.of(limit)[axis] = in_joint_units; });
}

void RampSettings::reset_limits() {
    notifier_.notify([&](ProgramObserver& observer) { observer.no_ramp_limits(position_.axes()); });
    if (!are_supported()) return;
    change([this](motion::ProgrammedRamps& ramps) {
        const rrs::RampMode mode = ramps.mode;
        ramps = motion::ProgrammedRamps(motion_.setup().joint_count());
        ramps.mode = mode;
    });
}

bool RampSettings::are_supported() {
    const motion::PlanResult checked = motion_.source().check_ramps();
    if (!checked) warnings_.add(checked.error().message);
    return checked.has_value();
}

template <typename Change>
void RampSettings::change(const Change& change) {
    motion::ProgrammedRamps ramps =
        programmed_ ? *programmed_ : motion::ProgrammedRamps(motion_.setup().joint_count());
    change(ramps);
    programmed_ = std::make_shared<const motion::ProgrammedRamps>(std::move(ramps));
}

}  // namespace gsim::simulation
