#include <utility>

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
    KeySchema key =
        choice_key("model", "\"exact-stop\"", std::move(models),
                   "where the values come from that the other keys change: a controller that is built "
                   "in, or in a machine file a controller file of one's own, which ends in .toml");
    key.open = true;
    return key;
}

std::vector<KeySchema> look_ahead_schema() {
    return {
        model_key(),
        text_key("name", "", "what the rules are called; else as the model"),
        choice_key("planner", "\"rest-to-rest\"", {"rest-to-rest", "look-ahead", "linuxcnc", "klipper"},
                   "each move begins and ends at rest, or speeds are planned ahead, or as LinuxCNC or "
                   "Klipper does"),
        choice_key("linuxcnc_release", "\"2.9\"", {"2.9", "2.10"}, "whose planner the planner linuxcnc is"),
        number_key("look_ahead_blocks", {.min = 1, .max = 1e5, .integer_only = true}, "100",
                   "how many blocks are known ahead, the one under way included"),
        choice_key(
            "corner", "\"stop\"", kCornerNames,
            "what limits the speed at corners in continuous mode (G64): a stop, the jump of speed that "
            "the axes stand, the speed on an arc that misses the corner by junction_deviation_mm; or the "
            "corner is rounded, with a constant acceleration or one that grows and falls"),
        choice_key("exact_path_corner", "\"stop\"", kCornerNames, "the same in exact path mode (G61)"),
        flag_key("exact_path_stops", false,
                 "the control has no exact path mode: what asks for one is an exact stop"),
        number_key("junction_deviation_mm", kNotNegative, "0.01", "of the corner rule junction-deviation"),
        number_key(
            "blend_tolerance_mm", kNotNegative, "0.05",
            "how far a blend may miss its corner where the program sets no tolerance (G64 P); 0: corners "
            "are not rounded, they stop"),
        number_key("blend_tolerance_deg", kNotNegative, "0.5",
                   "the same of the rotary axes, whatever the program says"),
        number_key(
            "speed_step_s", kPositive, "0.01",
            "the jump of speed that an axis without max_speed_step_mm_s stands is what its acceleration "
            "makes in this time"),
        number_key("square_corner_velocity_mm_s", kNotNegative, "5.0",
                   "of the planner klipper: the speed at a right angle"),
        number_key("minimum_cruise_ratio", kFractionBelowOne, "0.5",
                   "of the planner klipper: the share of each rise and fall of the speed that is passed at "
                   "one speed at least"),
        flag_key("stop_between_rapid_and_feed", true, "moves of both kinds meet at rest"),
    };
}

std::vector<KeySchema> path_schema() {
    return {
        flag_key(
            "own_ramps", false,
            "rotary axes beside a move of the tool, and U, V, W beside X, Y, Z, arrive with it but by ramps "
            "of their own; of the planner rest-to-rest alone"),
        flag_key("interpolated_rapids", true,
                 "the axes of a rapid move arrive together; else each goes by itself, so that the way is no "
                 "straight line"),
        flag_key("limit_jerk", false, "ramps keep the axes' jerk limits; else they are straight"),
        number_key(
            "ramp_step_s", kStep, "0.0",
            "with limit_jerk: ramps go in steps of this time, as in grblHAL built with jerk; 0: exactly"),
        choice_key("path_measure", "\"tool\"", {"tool", "all-axes"},
                   "what speeds count along: the tool's way, or the norm of all axes' ways, a degree as a "
                   "millimetre, as in grbl"),
        choice_key("feed_measure", "\"tool\"", {"tool", "all-axes"},
                   "the same of the feed of moves of rotary axes and others, with path_measure all-axes"),
        number_key(
            "centripetal_share", kPositive, "0.866",
            "share of the acceleration limit that the way round a curve may take; from 1 on ramps have all "
            "of it beside; inf: curves do not slow the motion"),
        number_key("continuous_acceleration_share", kPositiveFraction, "1.0",
                   "share of the acceleration that moves in continuous mode (G64) speed up and slow down "
                   "with"),
        number_key("block_time_s", kStep, "0.0",
                   "what the control takes to make a block ready: no move is made in less"),
        number_key("arc_chord_tolerance_mm", kStep, "0.0",
                   "arcs become chords that lie off the circle by this much; 0: they stay arcs"),
        number_key("spline_chord_tolerance_mm", kStep, "0.0",
                   "splines become chords whose middles lie off them by this much; 0: pairs of arcs"),
        number_key(
            "arc_resolution_mm", kStep, "0.0",
            "of the planner klipper: arcs become chords that stand for as much of the arc at least; 0: "
            "the control knows no arcs"),
        number_key("tcp_tolerance_mm", kPositive, "0.001",
                   "how far the tip may leave its way under G43.4 and in moves to poses, where the joints go "
                   "curved ways"),
        flag_key("inverse_time_of_chords", false,
                 "the feed of an arc in inverse time mode (G93) counts once for each chord, as in grbl 1.1"),
        choice_key(
            "orientation", "\"joints\"", {"joints", "great-circle"},
            "how the tool turns in feed moves: by the angles of the rotary axes, or its direction along "
            "the great circle"),
        number_key("least_feed_mm_min", kNotNegative, "0.0", "a lower feed is raised to it"),
        number_key("retract_length_mm", kNotNegative, "0.0",
                   "how far G10 of the dialect klipper draws the filament back; 0: G10 and G11 are unknown"),
        number_key("retract_speed_mm_s", kPositive, "20.0", "how fast it does"),
        number_key("unretract_extra_length_mm", kNotNegative, "0.0", "how much farther G11 pushes it"),
        number_key("unretract_speed_mm_s", kPositive, "10.0", "how fast it does"),
    };
}

std::vector<KeySchema> wait_schema() {
    return {
        number_key("settle_s", kNotNegative, "0.0", "time at each exact stop until the axes are in position"),
        number_key("position_gain_1_s", kStep, "0.0",
                   "gain Kv of the axes' position loops: exact stops also wait until the following error is "
                   "within the band; 0: they do not"),
        number_key("in_position_mm", kPositive, "0.01", "the band of each linear axis"),
        number_key("in_position_deg", kPositive, "0.01", "the band of each rotary axis"),
        table_key("stops", "words, and when the control waits at them; else as the model has it"),
        table_key("overrides",
                  "what the control takes of its operator's overrides; else as the model has it"),
        number_key("peck_clearance_mm", kNotNegative, "0.254",
                   "G73 of rs274ngc backs off by it, and G83 comes back to so far above the last depth"),
        number_key("rest_s", kNotNegative, "0.0",
                   "time at each stop that waits for the program's next block (dwell, M code)"),
        number_key("dwell_step_s", kStep, "0.0", "dwells are raised to a multiple of it; 0: they are not"),
        number_key("servo_period_s", kStep, "0.0", "of the controller's position loop; 0: continuous"),
        number_key("corner_override_percent", kPercent, "100.0",
                   "feed at inside corners of cutter compensation in G62 (9/Series), of F"),
        number_key("corner_override_before_mm", kNotNegative, "0.0", "from how far before the corner"),
        number_key("corner_override_after_mm", kNotNegative, "0.0", "to how far behind it"),
        number_key("corner_override_angle_deg", kNotNegative, "90.0",
                   "the greatest angle between the two moves that counts as a corner; 180 is straight on"),
    };
}

std::vector<KeySchema> drilling_schema() {
    return {
        number_key("peck_dwell_s", kNotNegative, "0.0", "they wait so long at the bottom of each peck"),
        flag_key("pecks_feed_down", false,
                 "G83 leaves the hole as after the last peck, and feeds all the way down again, as in "
                 "grblHAL"),
        flag_key("boring_cycles", true,
                 "G85, G86 and G89 of rs274ngc bore; else they are read and nothing moves, as in grblHAL"),
    };
}

TableSchema stops_table() {
    TableSchema table{.at = {"controller", "stops"},
                      .meaning =
                          "when the control waits at a word until all moves have been made: always, where "
                          "it changes something, or never"};
    for (const std::string_view word : stop_words()) {
        table.keys.push_back(choice_key(std::string(word), "", {"always", "on-change", "never"},
                                        "when the control waits at it; else as the model has it"));
    }
    return table;
}

TableSchema overrides_table() {
    KeySchema rapids = list_key("rapid_percents", KeyKind::number, 0,
                                "the values that the rapid override has, rising; none: it has all");
    rapids.range = kPercent;
    rapids.fallback = "[]";
    return {.at = {"controller", "overrides"},
            .meaning = "what the operator's overrides may be",
            .keys = {number_key("feed_min_percent", kNotNegative, "0.0", "the least feed override"),
                     number_key("feed_max_percent", kPositive, "200.0", "the greatest feed override"),
                     number_key("rapid_max_percent", kPercent, "100.0", "the greatest rapid override"),
                     std::move(rapids),
                     number_key("spindle_min_percent", kNotNegative, "0.0", "the least spindle override"),
                     number_key("spindle_max_percent", kPositive, "200.0", "the greatest spindle override"),
                     flag_key("feed_of_probes", true, "the feed override counts for probing moves, too"),
                     number_key("planned_feed_percent", kPositive, "100.0",
                                "of the planner linuxcnc: the feed override for which it plans the speeds of "
                                "junctions, whatever it is turned to"),
                     number_key("delay_s", kNotNegative, "0.0",
                                "until a change acts, as motion that is prepared goes on")}};
}

}  // namespace

std::vector<TableSchema> controller_schema() {
    TableSchema controller{.at = {"controller"}, .meaning = "how moves become motion"};
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
