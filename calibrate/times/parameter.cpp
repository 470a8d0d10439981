#include "calibrate/times/parameter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gsim::calibrate {

namespace {

using machine::Axis;
using machine::AxisKind;
using machine::Machine;
using rrs::ControllerRules;
using rrs::CornerRule;

constexpr double kFactor = 100;
constexpr double kFirstWait_s = 0.01;
constexpr double kLeastWait_s = 1e-5;

/// Axes whose figure is one parameter.
using Together = std::vector<std::size_t>;

std::vector<Together> axes_together(const Machine& machine, double Axis::*figure, bool each_axis) {
    std::map<std::pair<AxisKind, double>, Together> same;
    std::vector<Together> groups;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const Axis& axis = machine.axes[i];
        if (!std::isfinite(axis.*figure)) continue;
        if (each_axis) {
            groups.push_back({i});
        } else {
            same[{axis.kind, axis.*figure}].push_back(i);
        }
    }
    for (auto& [what, group] : same) groups.push_back(std::move(group));
    return groups;
}

std::string name_of(const Machine& machine, const Together& group, std::string_view figure,
                    std::string_view power) {
    std::vector<std::string> letters;
    for (const std::size_t i : group) letters.emplace_back(1, machine.axes[i].letter);
    const bool rotary = machine.axes[group.front()].kind == AxisKind::rotary;
    return fmt::format("{} {}: {}_{}_s{}", group.size() == 1 ? "axis" : "axes", fmt::join(letters, ", "),
                       figure, rotary ? "deg" : "mm", power);
}

void add_axes(const Machine& machine, double Axis::*figure, std::string_view name, std::string_view power,
              bool each_axis, std::vector<Parameter>& parameters) {
    for (const Together& group : axes_together(machine, figure, each_axis)) {
        const double now = machine.axes[group.front()].*figure;
        parameters.push_back({name_of(machine, group, name, power), now / kFactor, now * kFactor,
                              [group, figure](const Machine& of) { return of.axes[group.front()].*figure; },
                              [group, figure](Machine& of, double value) {
                                  for (const std::size_t i : group) of.axes[i].*figure = value;
                              }});
    }
}

void add_rule(double ControllerRules::*rule, std::string_view name, double least, double most,
              std::vector<Parameter>& parameters) {
    parameters.push_back(
        {fmt::format("controller: {}", name), least, most,
         [rule, least, most](const Machine& of) { return std::clamp(of.controller.*rule, least, most); },
         [rule](Machine& of, double value) { of.controller.*rule = value; }});
}

void add_scaled(const Machine& machine, double ControllerRules::*rule, std::string_view name,
                std::vector<Parameter>& parameters) {
    const double now = machine.controller.*rule;
    if (now > 0 && std::isfinite(now)) add_rule(rule, name, now / kFactor, now * kFactor, parameters);
}

void add_corners(const Machine& machine, std::vector<Parameter>& parameters) {
    const ControllerRules& rules = machine.controller;
    const auto has = [&](CornerRule rule) { return rules.corner == rule || rules.exact_path_corner == rule; };
    if (has(CornerRule::velocity_step))
        add_scaled(machine, &ControllerRules::speed_step_s, "speed_step_s", parameters);
    if (has(CornerRule::junction_deviation))
        add_scaled(machine, &ControllerRules::junction_deviation_mm, "junction_deviation_mm", parameters);
    if (has(CornerRule::smooth_blend) || has(CornerRule::parabolic_blend))
        add_scaled(machine, &ControllerRules::blend_tolerance_mm, "blend_tolerance_mm", parameters);
    if (std::isfinite(rules.centripetal_share))
        add_rule(&ControllerRules::centripetal_share, "centripetal_share", 0.05, 0.999, parameters);
}

void add_wait(double ControllerRules::*rule, std::string_view name, std::vector<Parameter>& parameters) {
    parameters.push_back({fmt::format("controller: {}", name), kLeastWait_s, 1,
                          [rule](const Machine& of) {
                              const double now = of.controller.*rule;
                              return now > 0 ? std::max(now, kLeastWait_s) : kFirstWait_s;
                          },
                          [rule](Machine& of, double value) { of.controller.*rule = value; }});
}

}  // namespace

std::vector<Parameter> open_parameters(const Machine& machine, bool each_axis) {
    std::vector<Parameter> parameters;
    add_axes(machine, &Axis::max_acceleration, "max_acceleration", "2", each_axis, parameters);
    if (machine.controller.limit_jerk)
        add_axes(machine, &Axis::max_jerk, "max_jerk", "3", each_axis, parameters);
    if (machine.controller.planner == rrs::PlannerKind::look_ahead) {
        add_corners(machine, parameters);
        add_wait(&ControllerRules::settle_s, "settle_s", parameters);
    }
    add_wait(&ControllerRules::rest_s, "rest_s", parameters);
    return parameters;
}

Machine with_values(Machine machine, const std::vector<Parameter>& parameters,
                    const std::vector<double>& values) {
    for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i].set(machine, values[i]);
    return machine;
}

}  // namespace gsim::calibrate
