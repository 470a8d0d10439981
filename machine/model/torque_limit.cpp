#include "machine/model/torque_limit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

constexpr std::string_view kKey = "'limit = \"torque\"' of [dynamics]";

std::optional<std::string> find_axis_fault(const Machine& machine) {
    if (std::none_of(machine.axes.begin(), machine.axes.end(), has_motor))
        return fmt::format("{} needs a motor: no axis has 'peak_n', 'peak_nm' or a curve of its motor", kKey);
    for (const Axis& axis : machine.axes) {
        const bool linear = axis.kind == AxisKind::linear;
        if (!std::isfinite(axis.max_speed))
            return fmt::format("{} needs '{}' of axis {}", kKey,
                               linear ? "max_speed_mm_s" : "max_speed_deg_s", axis.letter);
        if (!has_motor(axis) && !std::isfinite(axis.max_acceleration))
            return fmt::format("{} needs '{}' of axis {}, or '{}' where it has no motor", kKey,
                               linear ? "peak_n" : "peak_nm", axis.letter,
                               linear ? "max_acceleration_mm_s2" : "max_acceleration_deg_s2");
    }
    return std::nullopt;
}

std::optional<std::string> find_rule_fault(const rrs::ControllerRules& rules) {
    const auto does_not_go = [](std::string_view rule, std::string_view why) {
        return fmt::format("{} does not go with {} of [controller]: {}", kKey, rule, why);
    };
    if (rules.planner == rrs::PlannerKind::linuxcnc || rules.planner == rrs::PlannerKind::klipper)
        return does_not_go("the planners \"linuxcnc\" and \"klipper\"",
                           "these controls know constant accelerations alone");
    if (rules.arc_chord_tolerance_mm > 0)
        return does_not_go("'arc_chord_tolerance_mm'",
                           "controls that make chords of arcs (grbl, grblHAL) know "
                           "constant accelerations alone");
    if (rules.own_ramps)
        return does_not_go("'own_ramps'", "where an axis is while another one speeds up would not be known");
    if (!rules.interpolated_rapids)
        return does_not_go("'interpolated_rapids = false'",
                           "where an axis is while another one speeds up would not be known");
    if (rules.orientation == rrs::OrientationRule::great_circle)
        return does_not_go("'orientation = \"great-circle\"'", "rotary axes do not go in proportion there");
    if (rules.centripetal_share >= 1 && rules.planner == rrs::PlannerKind::look_ahead)
        return does_not_go("a 'centripetal_share' of 1 or more", "curves must leave something to the ramps");
    return std::nullopt;
}

}  // namespace

bool is_torque_limited(const Machine& machine) {
    return machine.dynamics && machine.dynamics->limit == AccelerationLimit::torque;
}

bool has_motor(const Axis& axis) {
    return std::isfinite(axis.drive.peak) || !axis.drive.curve_speeds.empty();
}

std::optional<std::string> find_torque_limit_fault(const Machine& machine) {
    if (!is_torque_limited(machine)) return std::nullopt;
    if (auto fault = find_axis_fault(machine)) return fault;
    return find_rule_fault(machine.controller);
}

}  // namespace gsim::machine
