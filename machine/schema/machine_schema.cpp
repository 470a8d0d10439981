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
        .keys = {required(table_key("machine", "what the machine is called, and its inverse")),
                 table_key("program", "what the control is given to read"),
                 table_key("path", "limits of the tool along its path"),
                 table_key("base", "from the world to the first frame of the joints that carry the tool"),
                 table_key("tool", "from the last joint's frame to the tool centre point"),
                 table_key("work", "from the last joint that carries the work to the work frame"),
                 table_key("controller", "how moves become motion"),
                 table_key("process", "what the tool works with, and the words that switch it"),
                 table_key("checks", "what a run looks for in the process"),
                 table_key("times", "how long words take"),
                 required(list_key("axis", KeyKind::table, 0, "the axes, from the world on")),
                 list_key("group", KeyKind::table, 0, "axes that are a unit of their own"),
                 list_key("shape", KeyKind::table, 0, "the bodies of the machine itself"),
                 list_key("ignore", KeyKind::list, 0, "pairs of these shapes that may touch"),
                 table_key("dynamics", "that forces and torques of the motors are worked out"),
                 list_key("mass", KeyKind::table, 0, "masses that go with the axes, the tool and the work"),
                 list_key("hose", KeyKind::table, 0, "hoses and cables that pull at them"),
                 table_key("calibration", "that figures were fitted to recorded runs"),
                 list_key("calibrated", KeyKind::table, 0, "these figures, and how sure they are")}};
}

TableSchema machine_table() {
    return {.at = {"machine"},
            .meaning = "what the machine is",
            .keys = {required(text_key("name", "", "for reports")),
                     choice_key("inverse", "\"none\"", {"none", "gantry", "numeric"},
                                "how axis values are found for a pose: in closed form (a gantry or a mill of "
                                "up to two rotary axes), by numbers (any chain), or not at all")}};
}

TableSchema program_table() {
    return {
        .at = {"program"},
        .meaning = "what the control is given to read",
        .keys = {text_key("dialect", "", "a language or a control, as the option --dialect takes them"),
                 choice_key("units", "", {"mm", "inch"},
                            "the unit in force when a program begins, until its G20 or G21; not said: mm")}};
}

TableSchema path_table() {
    return {
        .at = {"path"},
        .meaning = "limits of the tool along its path, whatever the axes could do",
        .keys = {
            number_key("max_feed_mm_s", kPositive, "inf", "cap of programmed feeds"),
            number_key("max_rapid_mm_s", kPositive, "inf", "cap of rapid moves"),
            number_key("max_acceleration_mm_s2", kPositive, "inf", "along the path, in feed moves"),
            number_key("max_rapid_acceleration_mm_s2", kPositive, "inf", "along the path, in rapid moves"),
            number_key(
                "max_jerk_mm_s3", kPositive, "inf",
                "of every move along the path, and across arcs; kept by LinuxCNC 2.10 with limit_jerk")}};
}

TableSchema frame_table(std::vector<std::string> at, bool many, std::string meaning) {
    return {.at = std::move(at), .many = many, .meaning = std::move(meaning), .keys = frame_schema()};
}

TableSchema process_table() {
    return {
        .at = {"process"},
        .meaning = "what the tool works with, and which words of programs switch it",
        .keys = {required(choice_key("kind", "", {"jet", "plasma", "laser", "spindle"},
                                     "for reports, pictures and checks")),
                 required(list_key("on", KeyKind::text, 0,
                                   "M codes that switch it on, each perhaps with words that must stand with "
                                   "it: \"M62 P0\"")),
                 required(list_key("off", KeyKind::text, 0, "M codes that switch it off"))}};
}

TableSchema checks_table() {
    return {
        .at = {"checks"},
        .meaning = "what a run looks for in the process",
        .keys = {flag_key("rapid_with_process_on", true, "rapid moves with the process on"),
                 flag_key("dwell_with_process_on", true, "dwells with the process on, longer than dwell_s"),
                 flag_key("end_with_process_on", true, "an end of the program with the process on"),
                 flag_key("feed_with_process_off", true, "feed moves with the process off"),
                 number_key("dwell_s", kPositive, "",
                            "the longest dwell with the process on, such as that of a pierce; else 60 of a "
                            "jet, 5 of a plasma, 10 of a laser, no limit of a spindle")}};
}

TableSchema times_table() {
    const auto time = [](std::string name, std::string meaning) {
        return number_key(std::move(name), kNotNegative, "0.0", std::move(meaning));
    };
    KeySchema codes = number_key("M0", kNotNegative, "", "M0 to M999: that M code, whatever the others say");
    codes.many = true;
    return {
        .at = {"times"},
        .meaning = "how long the machine takes for what a word sets going, before the program goes on",
        .keys = {time("tool_change_s", "M6"), time("tool_table_s", "G10 where it writes the table of tools"),
                 time("coolant_on_s", "M7, M8 (of ab9 M7 alone)"),
                 time("coolant_off_s", "M9 (of ab9 none: its M8 and M9 are the jet)"),
                 time("spindle_start_s", "M3, M4"), time("spindle_stop_s", "M5"),
                 time("process_on_s", "the words of [process] that switch it on, of a jet or a plasma"),
                 time("process_off_s", "those that switch it off"),
                 flag_key("before_first_move", true, "words before anything has moved take time, too"),
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
                      .where_key = "kind",
                      .where_value = rotary ? "rotary" : "linear"};
    table.keys = {
        required(choice_key("letter", "", {"A", "B", "C", "U", "V", "W", "X", "Y", "Z"},
                            "the word that programs move it with")),
        required(choice_key("kind", "", {"linear", "rotary"}, "whether it slides or turns")),
        choice_key("carries", "\"tool\"", {"tool", "work", "nothing"},
                   "what it moves; nothing: it feeds filament"),
        number_key(named("min"), kAny, "-inf", "the lower end of the range"),
        number_key(named("max"), kAny, "inf", "the upper end of the range"),
        number_key(named("max_speed", "_s"), kPositive, "inf", "limit of its speed"),
        number_key(named("max_acceleration", "_s2"), kPositive, "inf", "limit of its acceleration"),
        number_key(named("max_deceleration", "_s2"), kPositive, "",
                   "for slowing down, with any planner but linuxcnc; else as the acceleration"),
        number_key(named("max_jerk", "_s3"), kPositive, "inf", "kept by controllers with limit_jerk"),
        number_key(named("max_speed_step", "_s"), kPositive, "inf",
                   "jump of speed that it stands at a corner, for the corner rule velocity-step; else by the "
                   "controller's speed_step_s"),
        number_key(
            named("step"), kStep, "0.0",
            "smallest step of the axis, to which a look-ahead controller rounds the ends of its blocks"),
        number_key(named("home"), kFinite, "0.0", "where it stands when a run begins; within the range"),
        number_key(named("home2"), kFinite, "", "the second home position; within the range"),
        number_key(named("home3"), kFinite, "", "the third one"),
        number_key(named("home4"), kFinite, "", "the fourth one"),
        number_key(named("zero"), kFinite, "0.0", "what it reads where its joint is at zero")};
    if (rotary) {
        table.keys.push_back(
            choice_key("turning", "\"limited\"", {"limited", "shortest", "unwind"},
                       "absolute angles are meant as they stand, are reached the shorter way "
                       "round, or count from the last whole turn made"));
    }
    table.keys.push_back(choice_key(
        "direction", "", {"x", "y", "z", "-x", "-y", "-z"},
        "which way the tool goes against the work as the value grows; of a rotary axis, about which "
        "axis it turns. This, frame or dh is required"));
    table.keys.push_back(
        table_key("frame",
                  "from the joint before to this one; the joint moves along or about its Z or, with "
                  "direction, as that says"));
    table.keys.push_back(
        table_key("dh", "instead of direction: its row of the Denavit-Hartenberg table, behind the frame"));
    for (KeySchema& key : drive_schema(rotary)) table.keys.push_back(std::move(key));
    for (KeySchema& key : servo_schema()) table.keys.push_back(std::move(key));
    return table;
}

TableSchema dh_table() {
    return {.at = {"axis", "dh"},
            .many = true,
            .meaning = "a row is Rz(theta) Tz(d) Tx(a) Rx(alpha); the joint's value adds to d or theta",
            .keys = {number_key("theta_deg", kFinite, "0.0", "turn about Z"),
                     number_key("d_mm", kFinite, "0.0", "way along Z"),
                     number_key("a_mm", kFinite, "0.0", "way along X"),
                     number_key("alpha_deg", kFinite, "0.0", "turn about X")}};
}

TableSchema group_table() {
    return {
        .at = {"group"},
        .many = true,
        .meaning = "axes that are a unit of their own: a positioner, a track",
        .keys = {required(text_key("name", "", "as programs call it: letters, digits and _")),
                 required(list_key("axes", KeyKind::text, 0, "letters of its axes")),
                 choice_key("motion", "\"synchronous\"", {"synchronous", "coordinated", "independent"},
                            "how they move beside the tool's moves to poses, until a program says another "
                            "way")}};
}

TableSchema shape_table() {
    return {
        .at = {"shape"},
        .many = true,
        .meaning = "a body of the machine itself",
        .keys = {
            required(text_key("name", "", "a name of its own")),
            required(text_key("on", "", "\"base\", the letter of an axis, \"tool\", \"work\", or \"jet\"")),
            required(table_key("shape", "one of box_mm, cylinder_mm, capsule_mm, sphere_mm and mesh")),
            table_key("frame", "where it is on that"),
            number_key("density_kg_m3", kNotNegative, "0.0",
                       "of a body whose mass counts for forces and torques; a mesh must be closed")}};
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
        frame_table({"axis", "frame"}, true, "from the joint before to this one"),
        dh_table(),
        group_table(),
        shape_table(),
        {.at = {"shape", "shape"}, .many = true, .meaning = "the form of a body", .keys = shape_schema()},
        frame_table({"shape", "frame"}, true, "where a body is")};
    for (TableSchema& table : dynamics_schema()) schema.push_back(std::move(table));
    for (TableSchema& table : calibration_schema()) schema.push_back(std::move(table));
    for (TableSchema& table : controller_schema()) {
        if (!table.at.empty()) schema.push_back(std::move(table));
    }
    return schema;
}

}  // namespace gsim::machine
