#include <utility>

#include "controller/services/planner_capabilities.h"
#include "machine/file/controller_file.h"
#include "machine/model/stop_keys.h"
#include "machine/schema/key_schema.h"

namespace gsim::machine {

namespace {

const std::vector<std::string> kCornerNames{"stop", "velocity-step", "junction-deviation", "parabolic-blend",
                                            "smooth-blend"};

KeySchema model_key() {
    std::vector<std::string> models;
    for (const std::string_view name : built_in_controllers()) models.emplace_back(name);
    KeySchema key = choice_key("model", "\"exact-stop\"", std::move(models),
                               "source of the values that the other keys change: a built-in controller or, "
                               "in a machine file, a controller file, which ends in .toml");
    key.open = true;
    return key;
}

std::vector<KeySchema> look_ahead_schema() {
    constexpr auto planners = rrs::planner_names();
    return {
        model_key(),
        text_key("name", "", "name of the rules; default: the model"),
        choice_key("planner", "\"rest-to-rest\"", {planners.begin(), planners.end()},
                   "each move begins and ends at standstill, or speeds are planned ahead, or as LinuxCNC or "
                   "Klipper does"),
        choice_key("linuxcnc_release", "\"2.9\"", {"2.9", "2.10"}, "release of the LinuxCNC planner"),
        number_key("look_ahead_blocks", {.min = 1, .max = 1e5, .integer_only = true}, "100",
                   "number of blocks known ahead, including the current one"),
        choice_key("corner", "\"stop\"", kCornerNames,
                   "rule for the speed at corners in continuous mode (G64): a stop, the speed jump permitted "
                   "for the axes, the speed on an arc that misses the corner by junction_deviation_mm; or "
                   "the corner is rounded, with constant or with ramped acceleration"),
        choice_key("exact_path_corner", "\"stop\"", kCornerNames, "the same in exact path mode (G61)"),
        flag_key("exact_path_stops", false,
                 "the controller has no exact path mode: a program that selects it gets exact stops"),
        number_key("junction_deviation_mm", kNotNegative, "0.01", "for the corner rule junction-deviation"),
        number_key("blend_tolerance_mm", kNotNegative, "0.05",
                   "max deviation of a blend from its corner if the program sets no tolerance (G64 P); 0: "
                   "corners are not rounded, the axes stop"),
        number_key("blend_tolerance_deg", kNotNegative, "0.5",
                   "the same for the rotary axes, regardless of the program"),
        number_key(
            "speed_step_s", kPositive, "0.01",
            "permitted speed jump of an axis without max_speed_step_mm_s: its acceleration times this time"),
        number_key("square_corner_velocity_mm_s", kNotNegative, "5.0",
                   "for the planner klipper: the speed at a right angle"),
        number_key("minimum_cruise_ratio", kFractionBelowOne, "0.5",
                   "for the planner klipper: min share of each acceleration and deceleration that is "
                   "travelled at constant speed"),
        flag_key("stop_between_rapid_and_feed", true, "the axes stop between moves of different kinds"),
    };
}

std::vector<KeySchema> path_schema() {
    return {
        flag_key("independent_ramps", false,
                 "rotary axes that accompany a tool move, and U, V, W that accompany X, Y, Z, arrive with it "
                 "but with separate ramps; only for the planner rest-to-rest"),
        flag_key("interpolated_rapids", true,
                 "the axes of a rapid move arrive together; else they move independently, so that the path "
                 "is not straight"),
        flag_key("limit_jerk", false,
                 "ramps respect the jerk limits of the axes; else accelerations are constant"),
        number_key("ramp_step_s", kStep, "0.0",
                   "with limit_jerk: ramps have steps of this duration, as in grblHAL built with jerk; 0: "
                   "exact ramps"),
        choice_key("path_measure", "\"tool\"", {"tool", "all-axes"},
                   "length that speeds refer to: the path of the tool, or the norm over all axes, a degree "
                   "as a millimetre, as in grbl"),
        choice_key("feed_measure", "\"tool\"", {"tool", "all-axes"},
                   "the same for the feed of moves of rotary axes and others, with path_measure all-axes"),
        number_key("centripetal_share", kPositive, "0.866",
                   "share of the acceleration limit that curves may use; from 1 on ramps have the full limit "
                   "in addition; inf: curves do not slow the motion"),
        number_key(
            "continuous_acceleration_share", kPositiveFraction, "1.0",
            "share of the acceleration that moves in continuous mode (G64) use to speed up and slow down"),
        number_key("block_time_s", kStep, "0.0",
                   "time that the controller needs to prepare a block: no move is shorter"),
        number_key("arc_chord_tolerance_mm", kStep, "0.0",
                   "arcs become chords with this max deviation from the circle; 0: they stay arcs"),
        number_key("spline_chord_tolerance_mm", kStep, "0.0",
                   "splines become chords whose midpoints deviate by this much; 0: pairs of arcs"),
        number_key("arc_resolution_mm", kStep, "0.0",
                   "for the planner klipper: arcs become chords of at least this length along the arc; 0: "
                   "the controller does not support arcs"),
        number_key("tcp_tolerance_mm", kPositive, "0.001",
                   "max path deviation of the TCP under G43.4 and in moves to poses, where the joints move "
                   "on curves"),
        flag_key("inverse_time_of_chords", false,
                 "the feed of an arc in inverse time mode (G93) counts once for each chord, as in grbl 1.1"),
        choice_key("orientation", "\"joints\"", {"joints", "great-circle"},
                   "rotation of the tool in feed moves: by the angles of the rotary axes, or its direction "
                   "along the great circle"),
        number_key("min_feed_mm_min", kNotNegative, "0.0", "min feed; lower feeds are raised to it"),
        number_key(
            "retract_length_mm", kNotNegative, "0.0",
            "distance by which G10 of the dialect klipper retracts the filament; 0: G10 and G11 are unknown"),
        number_key("retract_speed_mm_s", kPositive, "20.0", "speed of this motion"),
        number_key("unretract_extra_length_mm", kNotNegative, "0.0",
                   "additional distance by which G11 pushes it"),
        number_key("unretract_speed_mm_s", kPositive, "10.0", "speed of this motion"),
    };
}

std::vector<KeySchema> wait_schema() {
    return {
        number_key("settle_s", kNotNegative, "0.0", "time at each exact stop until the axes are in position"),
        number_key("position_gain_1_s", kStep, "0.0",
                   "gain Kv of the axes' position loops: exact stops also wait until the following error is "
                   "within the band; 0: they do not"),
        number_key("in_position_mm", kPositive, "0.01", "in-position band of each linear axis"),
        number_key("in_position_deg", kPositive, "0.01", "in-position band of each rotary axis"),
        table_key("stops", "words, and when the controller waits at them; default: as in the model"),
        table_key("overrides", "limits of the operator's overrides; default: as in the model"),
        number_key("peck_clearance_mm", kNotNegative, "0.254",
                   "distance by which G73 of rs274ngc retracts, and distance above the last depth to which "
                   "G83 returns"),
        number_key("standstill_s", kNotNegative, "0.0",
                   "time at each stop that waits for the program's next block (dwell, M code)"),
        number_key("dwell_step_s", kStep, "0.0", "dwells are raised to a multiple of it; 0: they are not"),
        number_key("servo_period_s", kStep, "0.0",
                   "sampling period of the controller's position loop; 0: continuous"),
        number_key("corner_override_percent", kPercent, "100.0",
                   "feed in percent of F at inside corners of cutter compensation in G62 (9/Series)"),
        number_key("corner_override_before_mm", kNotNegative, "0.0",
                   "start of the reduced feed: distance before the corner"),
        number_key("corner_override_after_mm", kNotNegative, "0.0",
                   "end of the reduced feed: distance after the corner"),
        number_key("corner_override_angle_deg", kNotNegative, "90.0",
                   "max angle between the two moves that counts as a corner; 180 is straight on"),
    };
}

std::vector<KeySchema> drilling_schema() {
    return {
        number_key("peck_dwell_s", kNotNegative, "0.0", "dwell at the bottom of each peck"),
        flag_key(
            "pecks_feed_down", false,
            "G83 leaves the hole as after the last peck and feeds down the full depth again, as in grblHAL"),
        flag_key("boring_cycles", true,
                 "G85, G86 and G89 of rs274ngc bore; else they are read but do not move, as in grblHAL"),
    };
}

TableSchema stops_table() {
    TableSchema table{.at = {"controller", "stops"},
                      .meaning =
                          "when the controller waits at a word until all moves are finished: always, if the "
                          "word changes something, or never"};
    for (const std::string_view word : stop_words()) {
        table.keys.push_back(choice_key(std::string(word), "", {"always", "on-change", "never"},
                                        "when the controller waits at this word; default: as in the model"));
    }
    return table;
}

TableSchema overrides_table() {
    KeySchema rapids = list_key("rapid_percents", KeyKind::number, 0,
                                "the allowed values of the rapid override, ascending; none: all values");
    rapids.range = kPercent;
    rapids.fallback = "[]";
    return {.at = {"controller", "overrides"},
            .meaning = "ranges of the operator's overrides",
            .keys = {number_key("feed_min_percent", kNotNegative, "0.0", "the min feed override"),
                     number_key("feed_max_percent", kPositive, "200.0", "the max feed override"),
                     number_key("rapid_max_percent", kPercent, "100.0", "the max rapid override"),
                     std::move(rapids),
                     number_key("spindle_min_percent", kNotNegative, "0.0", "the min spindle override"),
                     number_key("spindle_max_percent", kPositive, "200.0", "the max spindle override"),
                     flag_key("feed_of_probes", true, "the feed override also applies to probing moves"),
                     number_key("planned_feed_percent", kPositive, "100.0",
                                "for the planner linuxcnc: the feed override for which it plans the speeds "
                                "of junctions, regardless of the actual override"),
                     number_key("delay_s", kNotNegative, "0.0",
                                "delay until a change takes effect, while prepared motion continues")}};
}

}  // namespace

std::vector<TableSchema> controller_schema() {
    TableSchema controller{.at = {"controller"}, .meaning = "planning of moves"};
    for (auto part : {look_ahead_schema(), path_schema(), wait_schema(), drilling_schema()})
        controller.keys.insert(controller.keys.end(), part.begin(), part.end());
    return {{.at = {},
             .meaning = "the controller file",
             .keys = {required(table_key("controller", "the rules"))}},
            std::move(controller),
            stops_table(),
            overrides_table()};
}

}  // namespace gsim::machine
