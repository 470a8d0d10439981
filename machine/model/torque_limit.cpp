#include "machine/model/torque_limit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

constexpr std::string_view kKey = "'limit = \"torque\"' of [dynamics]";

std::optional<std::string> find_axis_error(const Machine& machine) {
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

std::optional<std::string> find_rule_error(const rrs::ControllerRules& rules) {
    const auto unsupported = [](std::string_view rule, std::string_view reason) {
        return fmt::format("{} does not go with {} of [controller]: {}", kKey, rule, reason);
    };
    if (rules.planner == rrs::PlannerKind::linuxcnc || rules.planner == rrs::PlannerKind::klipper)
        return unsupported("the planners \"linuxcnc\" and \"klipper\"",
                           "these controls know constant accelerations alone");
    if (rules.arc_chord_tolerance_mm > 0)
        return unsupported("'arc_chord_tolerance_mm'",
                           "controls that make chords of arcs (grbl, grblHAL) know "
                           "constant accelerations alone");
    if (rules.independent_ramps)
        return unsupported("'own_ramps'", "where an axis is while another one speeds up would not be known");
    if (!rules.interpolated_rapids)
        return unsupported("'interpolated_rapids = false'",
                           "where an axis is while another one speeds up would not be known");
    if (rules.orientation == rrs::OrientationRule::great_circle)
        return unsupported("'orientation = \"great-circle\"'", "rotary axes do not go in proportion there");
    if (rules.centripetal_share >= 1 && rules.planner == rrs::PlannerKind::look_ahead)
        return unsupported("a 'centripetal_share' of 1 or more", "curves must leave something to the ramps");
    return std::nullopt;
}

}  // namespace

bool is_torque_limited(const Machine& machine) {
    return machine.dynamics && machine.dynamics->limit == AccelerationLimit::torque;
}

bool has_motor(const Axis& axis) {
    return std::isfinite(axis.drive.peak) || !axis.drive.curve_speeds.empty();
}

std::optional<std::string> find_torque_limit_error(const Machine& machine) {
    if (!is_torque_limited(machine)) return std::nullopt;
    if (auto error = find_axis_error(machine)) return error;
    return find_rule_error(machine.controller);
}

}  // namespace gsim::machine
