#include <utility>

#include "machine/file/calibration_section.h"
#include "machine/schema/dynamics_schema.h"
#include "machine/schema/key_schema.h"

namespace gsim::machine {

namespace {

TableSchema document_table() {
    return {
        .at = {},
        .meaning = "the machine file",
        .keys = {required(table_key("machine", "name of the machine, and its inverse")),
                 table_key("program", "the programs that the controller reads"),
                 table_key("path", "limits of the tool along its path"),
                 table_key("base", "from the world to the first frame of the joints that carry the tool"),
                 table_key("tool", "from the last joint's frame to the tool centre point"),
                 table_key("work", "from the last joint that carries the work to the work frame"),
                 table_key("controller", "planning of moves"),
                 table_key("process", "the process of the tool, and the words that switch it"),
                 table_key("checks", "process checks of a run"), table_key("times", "durations of words"),
                 required(list_key("axis", KeyKind::table, 0, "the axes, starting from the world")),
                 list_key("group", KeyKind::table, 0, "axes that form a separate unit"),
                 list_key("shape", KeyKind::table, 0, "the bodies of the machine itself"),
                 list_key("ignore", KeyKind::list, 0, "pairs of these shapes that may be in contact"),
                 table_key("dynamics", "computation of the forces and torques of the motors"),
                 list_key("mass", KeyKind::table, 0, "masses that move with the axes, the tool and the work"),
                 list_key("hose", KeyKind::table, 0, "hoses and cables that pull on them"),
                 table_key("calibration", "fit of parameters to recorded runs"),
                 list_key("calibrated", KeyKind::table, 0, "these parameters, and their uncertainty")}};
}

TableSchema machine_table() {
    return {.at = {"machine"},
            .meaning = "general data of the machine",
            .keys = {required(text_key("name", "", "for reports")),
                     choice_key("inverse", "\"none\"", {"none", "gantry", "numeric"},
                                "calculation of the axis values for a pose: in closed form (a gantry or a "
                                "mill with up to two rotary axes), numerically (any chain), or not at all")}};
}

TableSchema program_table() {
    return {.at = {"program"},
            .meaning = "the programs that the controller reads",
            .keys = {text_key("dialect", "", "a language or a controller, as for the option --dialect"),
                     choice_key("units", "", {"mm", "inch"},
                                "the unit at program start, until G20 or G21; default: mm")}};
}

TableSchema path_table() {
    return {
        .at = {"path"},
        .meaning = "limits of the tool along its path, in addition to those of the axes",
        .keys = {
            number_key("max_feed_mm_s", kPositive, "inf", "max programmed feed"),
            number_key("max_rapid_mm_s", kPositive, "inf", "max speed of rapid moves"),
            number_key("max_acceleration_mm_s2", kPositive, "inf", "along the path, in feed moves"),
            number_key("max_rapid_acceleration_mm_s2", kPositive, "inf", "along the path, in rapid moves"),
            number_key(
                "max_jerk_mm_s3", kPositive, "inf",
                "for every move along the path, and across arcs; used by LinuxCNC 2.10 with limit_jerk")}};
}

TableSchema frame_table(std::vector<std::string> at, bool many, std::string meaning) {
    return {.at = std::move(at), .many = many, .meaning = std::move(meaning), .keys = frame_schema()};
}

TableSchema process_table() {
    return {
        .at = {"process"},
        .meaning = "the process of the tool, and the words of programs that switch it",
        .keys = {required(choice_key("kind", "", {"jet", "plasma", "laser", "spindle"},
                                     "for reports, pictures and checks")),
                 required(list_key("on", KeyKind::text, 0,
                                   "M codes that switch it on, optionally with required words: \"M62 P0\"")),
                 required(list_key("off", KeyKind::text, 0, "M codes that switch it off"))}};
}

TableSchema checks_table() {
    return {.at = {"checks"},
            .meaning = "process checks of a run",
            .keys = {flag_key("rapid_with_process_on", true, "report rapid moves with the process on"),
                     flag_key("dwell_with_process_on", true,
                              "report dwells with the process on that are longer than dwell_s"),
                     flag_key("end_with_process_on", true, "report a program end with the process on"),
                     flag_key("feed_with_process_off", true, "report feed moves with the process off"),
                     number_key("dwell_s", kPositive, "",
                                "the max dwell with the process on, such as that of a pierce; default: 60 "
                                "for a jet, 5 for a plasma, 10 for a laser, no limit for a spindle")}};
}

TableSchema times_table() {
    const auto time = [](std::string name, std::string meaning) {
        return number_key(std::move(name), kNotNegative, "0.0", std::move(meaning));
    };
    KeySchema codes =
        number_key("M0", kNotNegative, "", "M0 to M999: time of this M code, regardless of the other keys");
    codes.many = true;
    return {.at = {"times"},
            .meaning = "time that the machine needs for the action of a word, before the program continues",
            .keys = {time("tool_change_s", "M6"), time("tool_table_s", "G10 if it writes the tool table"),
                     time("coolant_on_s", "M7, M8 (in ab9 only M7)"),
                     time("coolant_off_s", "M9 (none in ab9: its M8 and M9 switch the jet)"),
                     time("spindle_start_s", "M3, M4"), time("spindle_stop_s", "M5"),
                     time("process_on_s", "the words of [process] that switch it on, for a jet or a plasma"),
                     time("process_off_s", "the words that switch it off"),
                     flag_key("before_first_move", true, "words before the first move also take time"),
                     std::move(codes)}};
}

/// `unit`: "mm" or "deg".
TableSchema axis_table(bool rotary, const std::string& unit) {
    const auto named = [&](const std::string& before, const std::string& after = {}) {
        return before + "_" + unit + after;
    };
    TableSchema table{.at = {"axis"},
                      .many = true,
                      .meaning = rotary ? "a rotary axis" : "a linear axis",
                      .condition_key = "kind",
                      .condition_value = rotary ? "rotary" : "linear"};
    table.keys = {
        required(choice_key("letter", "", {"A", "B", "C", "U", "V", "W", "X", "Y", "Z"},
                            "the letter of the axis in programs")),
        required(choice_key("kind", "", {"linear", "rotary"}, "whether it is linear or rotary")),
        choice_key("carries", "\"tool\"", {"tool", "work", "nothing"},
                   "the part that it moves; nothing: it feeds filament"),
        number_key(named("min"), kAny, "-inf", "the lower limit of the range"),
        number_key(named("max"), kAny, "inf", "the upper limit of the range"),
        number_key(named("max_speed", "_s"), kPositive, "inf", "max speed"),
        number_key(named("max_acceleration", "_s2"), kPositive, "inf", "max acceleration"),
        number_key(named("max_deceleration", "_s2"), kPositive, "",
                   "max deceleration, with any planner except linuxcnc; default: as the acceleration"),
        number_key(named("max_jerk", "_s3"), kPositive, "inf",
                   "max jerk, used by controllers with limit_jerk"),
        number_key(named("max_speed_step", "_s"), kPositive, "inf",
                   "permitted speed jump at a corner, for the corner rule velocity-step; default: from "
                   "speed_step_s of the controller"),
        number_key(named("step"), kStep, "0.0",
                   "smallest step of the axis; a look-ahead controller rounds the ends of its blocks to it"),
        number_key(named("home"), kFinite, "0.0", "its position at the start of a run; within the range"),
        number_key(named("home2"), kFinite, "", "the second home position; within the range"),
        number_key(named("home3"), kFinite, "", "the third one"),
        number_key(named("home4"), kFinite, "", "the fourth one"),
        number_key(named("zero"), kFinite, "0.0", "the axis value if its joint is at zero")};
    if (rotary) {
        table.keys.push_back(choice_key("turning", "\"limited\"", {"limited", "shortest", "unwind"},
                                        "absolute angles are used as programmed, are reached in the shorter "
                                        "direction, or count from the last full turn"));
    }
    table.keys.push_back(choice_key("direction", "", {"x", "y", "z", "-x", "-y", "-z"},
                                    "direction of the tool relative to the work as the value increases; for "
                                    "a rotary axis, the axis of rotation. This, frame or dh is required"));
    table.keys.push_back(table_key("frame",
                                   "from the previous joint to this one; the joint moves along or about its "
                                   "Z or, with direction, along or about that"));
    table.keys.push_back(
        table_key("dh", "instead of direction: its row of the Denavit-Hartenberg table, after the frame"));
    for (KeySchema& key : drive_schema(rotary)) table.keys.push_back(std::move(key));
    for (KeySchema& key : servo_schema()) table.keys.push_back(std::move(key));
    return table;
}

TableSchema dh_table() {
    return {.at = {"axis", "dh"},
            .many = true,
            .meaning = "a row is Rz(theta) Tz(d) Tx(a) Rx(alpha); the joint's value adds to d or theta",
            .keys = {number_key("theta_deg", kFinite, "0.0", "rotation about Z"),
                     number_key("d_mm", kFinite, "0.0", "distance along Z"),
                     number_key("a_mm", kFinite, "0.0", "distance along X"),
                     number_key("alpha_deg", kFinite, "0.0", "rotation about X")}};
}

TableSchema group_table() {
    return {
        .at = {"group"},
        .many = true,
        .meaning = "axes that form a separate unit: a positioner, a track",
        .keys = {
            required(text_key("name", "", "its name in programs: letters, digits and _")),
            required(list_key("axes", KeyKind::text, 0, "letters of its axes")),
            choice_key("motion", "\"synchronous\"", {"synchronous", "coordinated", "independent"},
                       "how the axes move during moves of the tool to poses, unless a program changes it")}};
}

TableSchema shape_table() {
    return {
        .at = {"shape"},
        .many = true,
        .meaning = "a body of the machine itself",
        .keys = {required(text_key("name", "", "a unique name")),
                 required(text_key("on", "", "\"base\", an axis letter, \"tool\", \"work\", or \"jet\"")),
                 required(table_key("shape", "one of box_mm, cylinder_mm, capsule_mm, sphere_mm and mesh")),
                 table_key("frame", "its position on that object"),
                 number_key("density_kg_m3", kNotNegative, "0.0",
                            "for a body whose mass counts for forces and torques; a mesh must be closed")}};
}

}  // namespace

std::vector<TableSchema> machine_schema() {
    std::vector<TableSchema> schema{
        document_table(),
        machine_table(),
        program_table(),
        path_table(),
        frame_table({"base"}, false, "from the world to the first frame of the joints that carry the tool"),
        frame_table({"tool"}, false, "from the last joint's frame to the tool centre point"),
        frame_table({"work"}, false, "from the last joint that carries the work to the work frame"),
        process_table(),
        checks_table(),
        times_table(),
        axis_table(false, "mm"),
        axis_table(true, "deg"),
        frame_table({"axis", "frame"}, true, "from the previous joint to this one"),
        dh_table(),
        group_table(),
        shape_table(),
        {.at = {"shape", "shape"}, .many = true, .meaning = "shape of the body", .keys = shape_schema()},
        frame_table({"shape", "frame"}, true, "position of the body")};
    for (TableSchema& table : dynamics_schema()) schema.push_back(std::move(table));
    for (TableSchema& table : calibration_schema()) schema.push_back(std::move(table));
    for (TableSchema& table : controller_schema()) {
        if (!table.at.empty()) schema.push_back(std::move(table));
    }
    return schema;
}

}  // namespace gsim::machine
