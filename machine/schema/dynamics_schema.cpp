#include "machine/schema/dynamics_schema.h"

#include <utility>

namespace gsim::machine {

namespace {

KeySchema numbers_key(std::string name, std::size_t count, std::string meaning) {
    return list_key(std::move(name), KeyKind::number, count, std::move(meaning));
}

KeySchema on_key() {
    return required(text_key("on", "", "the letter of an axis, \"tool\" or \"work\""));
}

TableSchema mass_table() {
    return {.at = {"mass"},
            .many = true,
            .meaning = "a mass that goes with an axis, the tool or the work",
            .keys = {on_key(), required(number_key("mass_kg", kNotNegative, "", "how much it is")),
                     numbers_key("centre_mm", 3, "its centre, in the frame of what it goes with"),
                     numbers_key("inertia_kg_m2", 0,
                                 "its inertia tensor about the centre: [xx, yy, zz] or [xx, yy, zz, xy, yz, "
                                 "zx]; else it is a point")}};
}

TableSchema hose_table() {
    return {.at = {"hose"},
            .many = true,
            .meaning = "a hose or a cable that pulls at an axis, the tool or the work",
            .keys = {
                on_key(), numbers_key("point_mm", 3, "where it hangs, in the frame of that"),
                required(numbers_key("anchor_mm", 3, "where it comes from, in the world")),
                number_key("free_length_mm", kNotNegative, "0.0", "up to which it is slack"),
                number_key("stiffness_n_per_mm", kNotNegative, "0.0", "its pull for each mm beyond"),
                number_key("drag_n_per_mm_s", kNotNegative, "0.0", "its drag against the speed of its end")}};
}

}  // namespace

std::vector<KeySchema> drive_schema(bool rotary) {
    const std::string n = rotary ? "nm" : "n";
    const std::string mm = rotary ? "deg" : "mm";
    KeySchema speeds = numbers_key("curve_speed_" + mm + "_s", 0,
                                   "speeds from 0 up at which the motor brings up what the next key says; "
                                   "beyond the last one nothing");
    KeySchema peaks = numbers_key("curve_peak_" + n, 0, "what the motor brings up at these speeds");
    return {
        number_key("coulomb_" + n, kNotNegative, "0.0", "friction against motion, whatever its speed"),
        number_key("viscous_" + n + "_per_" + mm + "_s", kNotNegative, "0.0",
                   "friction in proportion to speed"),
        number_key(rotary ? "rotor_kg_m2" : "rotor_kg", kNotNegative, "0.0",
                   "what turns with the motor, as it is felt at the axis"),
        number_key("counterweight_" + n, kFinite, "0.0",
                   "what a balance takes off the motor, in the sense of the axis"),
        number_key("peak_" + n, kPositive, "inf", "the most that the motor brings up"),
        number_key("continuous_" + n, kPositive, "inf", "what it does without end, as a root mean square"),
        std::move(speeds),
        std::move(peaks)};
}

std::vector<KeySchema> servo_schema() {
    const NumberRange unit_interval{.min = 0, .max = 1};
    return {number_key("position_gain_1_s", {.min = 1}, "",
                       "gain Kv of its position loop, for following errors; else that of the controller"),
            number_key("velocity_feed_forward", unit_interval, "0.0",
                       "share of the speed that its loop is given ahead"),
            number_key("acceleration_feed_forward", unit_interval, "0.0",
                       "share of what the acceleration needs because of velocity_lag_s, given ahead"),
            number_key("velocity_lag_s", {.min = 1e-6, .max = 1, .allows_zero = true}, "0.0",
                       "time constant of its velocity loop"),
            number_key("command_delay_s", unit_interval, "0.0", "how late its loop gets the set points")};
}

std::vector<TableSchema> dynamics_schema() {
    return {{.at = {"dynamics"},
             .meaning = "that forces and torques of the motors are worked out",
             .keys = {numbers_key("gravity_m_s2", 3, "in the world; else [0.0, 0.0, -9.80665]"),
                      choice_key("limit", "\"axes\"", {"axes", "torque"},
                                 "what limits accelerations: those of the axes, or what the peaks of the "
                                 "motors allow at the places and speeds of each move")}},
            mass_table(),
            hose_table()};
}

}  // namespace gsim::machine
