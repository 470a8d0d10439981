#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "controller/services/planner_kind.h"

namespace gsim::rrs {

/// Chords that a planner makes of an arc.
enum class ArcChords {
    none,          ///< Arcs stay arcs.
    by_tolerance,  ///< If CurveRules::arc_chord_tolerance_mm is set.
    by_length,     ///< By KlipperRules::arc_resolution_mm.
};

/// S-curves that a planner makes if the jerk is limited.
enum class SCurves {
    none,          ///< Its ramps are straight.
    release_2_10,  ///< From LinuxcncRelease::v2_10 on.
    all,
};

/// What a kind of planner can do. The other code checks these instead of the kind.
struct PlannerCapabilities {
    PlannerKind kind;
    std::string_view name;  ///< Its name in machine files.
    bool stops_at_each_move;
    /// Plans joints that have independent ramps, or arrive at different times (CoordinationRules).
    bool plans_uncoordinated_joints;
    /// Passes corners by CornerRules, over a window of blocks that take BlockRules::time_s each.
    bool applies_corner_rules;
    /// Rounds corners within the tolerance of the program, whatever the CornerRules say.
    bool blends_at_tolerance;
    /// Divides the acceleration on curves by RampRules::centripetal_share.
    bool shares_acceleration_on_curves;
    /// Waits at exact stops until the axes are in position (PositionLoopRules).
    bool waits_in_position;
    bool counts_servo_periods;     ///< Its times depend on PositionLoopRules::servo_period_s.
    bool has_deceleration_limits;  ///< Else one limit holds for speeding up and slowing down.
    bool supports_torque_limits;   ///< Accelerations of a move may follow from the torques of the motors.
    bool accepts_programmed_ramps;
    bool plans_great_circles;  ///< Supports OrientationRule::great_circle.
    /// Passes the lines of joints that approximate a path of the TCP without a stop.
    bool plans_tool_paths;
    ArcChords arc_chords;
    SCurves s_curves;
    /// Word of the program that sets a speed factor, if the planner does not follow the operator's overrides;
    /// else empty.
    std::string_view speed_factor_word;
};

/// One row for each PlannerKind, in its order.
inline constexpr std::array kPlannerCapabilities{
    PlannerCapabilities{.kind = PlannerKind::rest_to_rest,
                        .name = "rest-to-rest",
                        .stops_at_each_move = true,
                        .plans_uncoordinated_joints = true,
                        .applies_corner_rules = false,
                        .blends_at_tolerance = false,
                        .shares_acceleration_on_curves = false,
                        .waits_in_position = false,
                        .counts_servo_periods = false,
                        .has_deceleration_limits = true,
                        .supports_torque_limits = true,
                        .accepts_programmed_ramps = true,
                        .plans_great_circles = true,
                        .plans_tool_paths = false,
                        .arc_chords = ArcChords::none,
                        .s_curves = SCurves::all,
                        .speed_factor_word = {}},
    PlannerCapabilities{.kind = PlannerKind::look_ahead,
                        .name = "look-ahead",
                        .stops_at_each_move = false,
                        .plans_uncoordinated_joints = false,
                        .applies_corner_rules = true,
                        .blends_at_tolerance = false,
                        .shares_acceleration_on_curves = true,
                        .waits_in_position = true,
                        .counts_servo_periods = false,
                        .has_deceleration_limits = true,
                        .supports_torque_limits = true,
                        .accepts_programmed_ramps = true,
                        .plans_great_circles = true,
                        .plans_tool_paths = true,
                        .arc_chords = ArcChords::by_tolerance,
                        .s_curves = SCurves::all,
                        .speed_factor_word = {}},
    PlannerCapabilities{.kind = PlannerKind::linuxcnc,
                        .name = "linuxcnc",
                        .stops_at_each_move = false,
                        .plans_uncoordinated_joints = false,
                        .applies_corner_rules = false,
                        .blends_at_tolerance = true,
                        .shares_acceleration_on_curves = false,
                        .waits_in_position = false,
                        .counts_servo_periods = true,
                        .has_deceleration_limits = false,
                        .supports_torque_limits = false,
                        .accepts_programmed_ramps = false,
                        .plans_great_circles = false,
                        .plans_tool_paths = false,
                        .arc_chords = ArcChords::none,
                        .s_curves = SCurves::release_2_10,
                        .speed_factor_word = {}},
    PlannerCapabilities{.kind = PlannerKind::klipper,
                        .name = "klipper",
                        .stops_at_each_move = false,
                        .plans_uncoordinated_joints = false,
                        .applies_corner_rules = false,
                        .blends_at_tolerance = false,
                        .shares_acceleration_on_curves = false,
                        .waits_in_position = false,
                        .counts_servo_periods = false,
                        .has_deceleration_limits = true,
                        .supports_torque_limits = false,
                        .accepts_programmed_ramps = false,
                        .plans_great_circles = false,
                        .plans_tool_paths = false,
                        .arc_chords = ArcChords::by_length,
                        .s_curves = SCurves::none,
                        .speed_factor_word = "M220"},
};

/// Returns what planners of `kind` can do.
constexpr const PlannerCapabilities& capabilities_of(PlannerKind kind) {
    return kPlannerCapabilities[static_cast<std::size_t>(kind)];
}

static_assert(
    [] {
        for (std::size_t i = 0; i < kPlannerCapabilities.size(); ++i) {
            if (kPlannerCapabilities[i].kind != static_cast<PlannerKind>(i)) return false;
        }
        return true;
    }(),
    "the rows have the order of PlannerKind");

/// Returns the names of all kinds in machine files, in the order of PlannerKind.
constexpr auto planner_names() {
    std::array<std::string_view, kPlannerCapabilities.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kPlannerCapabilities[i].name;
    return names;
}

/// Returns the names of the kinds without a capability, for messages: `"linuxcnc" and "klipper"`.
std::string planners_without(bool PlannerCapabilities::*capability);

}  // namespace gsim::rrs
