#include "machine/model/torque_limit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

constexpr std::string_view kKey = "'limit = \"torque\"' of [dynamics]";

std::optional<Error> find_axis_error(const Machine& machine) {
    if (std::none_of(machine.axes.begin(), machine.axes.end(), has_motor))
        return fmt::format("{} needs a motor: no axis has 'peak_n', 'peak_nm' or a motor curve", kKey);
    for (const Axis& axis : machine.axes) {
        const bool linear = axis.kind == AxisKind::linear;
        if (!std::isfinite(axis.max_speed))
            return fmt::format("{} needs '{}' of axis {}", kKey,
                               linear ? "max_speed_mm_s" : "max_speed_deg_s", axis.letter);
        if (!has_motor(axis) && !std::isfinite(axis.max_acceleration))
            return fmt::format("{} needs '{}' of axis {}, or '{}' if it has no motor", kKey,
                               linear ? "peak_n" : "peak_nm", axis.letter,
                               linear ? "max_acceleration_mm_s2" : "max_acceleration_deg_s2");
    }
    return std::nullopt;
}

std::optional<Error> find_rule_error(const rrs::ControllerRules& rules) {
    const auto unsupported = [](std::string_view rule, std::string_view reason) {
        return fmt::format("{} cannot be combined with {} of [controller]: {}", kKey, rule, reason);
    };
    if (!rules.capabilities().supports_torque_limits)
        return unsupported(
            "the planners " + rrs::planners_without(&rrs::PlannerCapabilities::supports_torque_limits),
            "these controllers support only constant accelerations");
    if (rules.curves.arc_chord_tolerance_mm > 0)
        return unsupported(
            "'arc_chord_tolerance_mm'",
            "controllers that convert arcs to chords (grbl, grblHAL) support only constant accelerations");
    if (rules.coordination.independent_ramps)
        return unsupported("'independent_ramps'",
                           "the position of an axis while another one accelerates would be unknown");
    if (!rules.coordination.interpolated_rapids)
        return unsupported("'interpolated_rapids = false'",
                           "the position of an axis while another one accelerates would be unknown");
    if (rules.coordination.orientation == rrs::OrientationRule::great_circle)
        return unsupported("'orientation = \"great-circle\"'", "rotary axes do not move in proportion then");
    if (rules.ramps.centripetal_share >= 1 && rules.capabilities().shares_acceleration_on_curves)
        return unsupported("a 'centripetal_share' of 1 or more",
                           "some acceleration must remain for the ramps in curves");
    return std::nullopt;
}

}  // namespace

bool is_torque_limited(const Machine& machine) {
    return machine.dynamics && machine.dynamics->limit == AccelerationLimit::torque;
}

bool has_motor(const Axis& axis) {
    return std::isfinite(axis.drive.peak) || !axis.drive.curve_speeds.empty();
}

std::optional<Error> find_torque_limit_error(const Machine& machine) {
    if (!is_torque_limited(machine)) return std::nullopt;
    if (auto error = find_axis_error(machine)) return error;
    return find_rule_error(machine.controller);
}

}  // namespace gsim::machine
