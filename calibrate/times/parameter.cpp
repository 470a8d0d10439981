#include "calibrate/times/parameter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "machine/file/times_section.h"

namespace gsim::calibrate {

namespace {

using machine::Axis;
using machine::AxisKind;
using machine::Machine;
using machine::MachineParameter;
using rrs::ControllerRules;
using rrs::CornerRule;

constexpr double kBoundFactor = 100;
constexpr double kInitialWait_s = 0.01;
constexpr double kMinWait_s = 1e-5;
constexpr double kMaxWait_s = 1;
constexpr double kMaxWordTime_s = 600;

/// Collector of open parameters.
class Parameters {
  public:
    explicit Parameters(const Machine& machine) : machine_(machine) {}

    /// Adds a parameter within a factor of the machine's value, if it has one.
    void add_scaled(MachineParameter parameter_id) {
        const double now = parameter_value(parameter_id);
        if (now > 0 && std::isfinite(now))
            found_.push_back({std::move(parameter_id), now, now / kBoundFactor, now * kBoundFactor});
    }
    void add(MachineParameter parameter_id, double min, double max) {
        const double now = parameter_value(parameter_id);
        found_.push_back({std::move(parameter_id), std::clamp(now, min, max), min, max});
    }
    void add_wait(const char* key) {
        const double now = parameter_value({"controller", key});
        found_.push_back({{"controller", key},
                          now > 0 ? std::max(now, kMinWait_s) : kInitialWait_s,
                          kMinWait_s,
                          std::max(kMaxWait_s, now)});
    }
    void add_word(const std::string& key) {
        const double now = parameter_value({"times", key});
        found_.push_back({{"times", key}, now, kMinWait_s, std::max(kMaxWordTime_s, now)});
    }
    std::vector<Parameter> release_parameters() { return std::move(found_); }

  private:
    double parameter_value(const MachineParameter& parameter_id) const {
        return machine::parameter_value(parameter_id, machine_).value_or(0);
    }

    const Machine& machine_;
    std::vector<Parameter> found_;
};

/// Returns letters of axes that share one parameter.
std::vector<std::string> group_axes(const Machine& machine, double Axis::*parameter_id, AxisKind kind,
                                    bool each_axis) {
    std::map<double, std::string> same;
    std::vector<std::string> groups;
    for (const Axis& axis : machine.axes) {
        if (axis.kind != kind || !std::isfinite(axis.*parameter_id)) continue;
        if (each_axis) {
            groups.emplace_back(1, axis.letter);
        } else {
            same[axis.*parameter_id] += axis.letter;
        }
    }
    for (auto& [value, group] : same) groups.push_back(std::move(group));
    return groups;
}

void add_axes(const Machine& machine, double Axis::*parameter_id, const char* linear, const char* rotary,
              bool each_axis, Parameters& parameters) {
    for (std::string& group : group_axes(machine, parameter_id, AxisKind::linear, each_axis))
        parameters.add_scaled({std::move(group), linear});
    for (std::string& group : group_axes(machine, parameter_id, AxisKind::rotary, each_axis))
        parameters.add_scaled({std::move(group), rotary});
}

void add_curves(const ControllerRules& rules, Parameters& parameters) {
    const MachineParameter share{"controller", "centripetal_share"};
    if (rules.ramps.centripetal_share < 1) {
        parameters.add(share, 0.05, 0.999);
    } else if (std::isfinite(rules.ramps.centripetal_share)) {
        parameters.add(share, 1, kBoundFactor);
    }
}

void add_corners(const ControllerRules& rules, Parameters& parameters) {
    const auto has = [&](CornerRule rule) {
        return rules.corners.continuous == rule || rules.corners.exact_path == rule;
    };
    if (has(CornerRule::velocity_step)) parameters.add_scaled({"controller", "speed_step_s"});
    if (has(CornerRule::junction_deviation)) parameters.add_scaled({"controller", "junction_deviation_mm"});
    if (has(CornerRule::smooth_blend) || has(CornerRule::parabolic_blend))
        parameters.add_scaled({"controller", "blend_tolerance_mm"});
    add_curves(rules, parameters);
    if (rules.ramps.continuous_acceleration_share < 1)
        parameters.add({"controller", "continuous_acceleration_share"}, 0.1, 1);
}

}  // namespace

std::vector<Parameter> free_parameters(const Machine& machine, const FreeParameters& open) {
    Parameters parameters(machine);
    add_axes(machine, &Axis::max_acceleration, "max_acceleration_mm_s2", "max_acceleration_deg_s2",
             open.each_axis, parameters);
    if (machine.controller.ramps.limit_jerk)
        add_axes(machine, &Axis::max_jerk, "max_jerk_mm_s3", "max_jerk_deg_s3", open.each_axis, parameters);
    if (open.speeds) {
        add_axes(machine, &Axis::max_speed, "max_speed_mm_s", "max_speed_deg_s", open.each_axis, parameters);
        for (const char* limit : {"max_feed_mm_s", "max_rapid_mm_s"}) parameters.add_scaled({"path", limit});
    }
    for (const char* limit : {"max_acceleration_mm_s2", "max_rapid_acceleration_mm_s2"})
        parameters.add_scaled({"path", limit});
    const rrs::PlannerCapabilities& planner = machine.controller.capabilities();
    if (planner.applies_corner_rules) {
        add_corners(machine.controller, parameters);
        parameters.add_scaled({"controller", "block_time_s"});
    }
    if (planner.waits_in_position) parameters.add_wait("settle_s");
    if (planner.counts_servo_periods) parameters.add_scaled({"controller", "servo_period_s"});
    parameters.add_wait("standstill_s");
    for (const std::string& key : machine::nonzero_time_keys(machine.times)) parameters.add_word(key);
    return parameters.release_parameters();
}

Machine with_values(Machine machine, const std::vector<Parameter>& parameters,
                    const std::vector<double>& values) {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        machine::set_value(parameters[i].parameter_id, values[i], machine);
    return machine;
}

}  // namespace gsim::calibrate
