#include "machine/schema/dynamics_schema.h"

#include <utility>

namespace gsim::machine {

namespace {

KeySchema numbers_key(std::string name, std::size_t count, std::string meaning) {
    return list_key(std::move(name), KeyKind::number, count, std::move(meaning));
}

KeySchema on_key() {
    return required(text_key("on", "", "an axis letter, \"tool\" or \"work\""));
}

TableSchema mass_table() {
    return {.at = {"mass"},
            .many = true,
            .meaning = "a mass that moves with an axis, the tool or the work",
            .keys = {on_key(), required(number_key("mass_kg", kNotNegative, "", "the mass")),
                     numbers_key("centre_mm", 3, "its centre, in the frame of the object that it moves with"),
                     numbers_key("inertia_kg_m2", 0,
                                 "its inertia tensor about the centre: [xx, yy, zz] or [xx, yy, zz, xy, yz, "
                                 "zx]; default: a point mass")}};
}

TableSchema hose_table() {
    return {.at = {"hose"},
            .many = true,
            .meaning = "a hose or a cable that pulls on an axis, the tool or the work",
            .keys = {
                on_key(), numbers_key("point_mm", 3, "where it is attached, in the frame of that object"),
                required(numbers_key("anchor_mm", 3, "where it starts, in the world")),
                number_key("free_length_mm", kNotNegative, "0.0", "length up to which it is slack"),
                number_key("stiffness_n_per_mm", kNotNegative, "0.0", "its pulling force for each mm beyond"),
                number_key("drag_n_per_mm_s", kNotNegative, "0.0",
                           "its damping force against the speed of its end")}};
}

}  // namespace

std::vector<KeySchema> drive_schema(bool rotary) {
    const std::string n = rotary ? "nm" : "n";
    const std::string mm = rotary ? "deg" : "mm";
    KeySchema speeds =
        numbers_key("curve_speed_" + mm + "_s", 0,
                    "speeds from 0 up for the forces or torques of the next key; beyond the last speed 0");
    KeySchema peaks = numbers_key("curve_peak_" + n, 0, "max force or torque of the motor at these speeds");
    return {number_key("coulomb_" + n, kNotNegative, "0.0", "friction against motion, independent of speed"),
            number_key("viscous_" + n + "_per_" + mm + "_s", kNotNegative, "0.0",
                       "friction proportional to speed"),
            number_key(rotary ? "rotor_kg_m2" : "rotor_kg", kNotNegative, "0.0",
                       "rotating inertia of the motor, as seen at the axis"),
            number_key("counterweight_" + n, kFinite, "0.0",
                       "counterbalance that relieves the motor, in the direction of the axis"),
            number_key("peak_" + n, kPositive, "inf", "the max force or torque of the motor"),
            number_key("continuous_" + n, kPositive, "inf",
                       "its continuous force or torque, as a root mean square"),
            std::move(speeds),
            std::move(peaks)};
}

std::vector<KeySchema> servo_schema() {
    const NumberRange unit_interval{.min = 0, .max = 1};
    return {number_key("position_gain_1_s", {.min = 1}, "",
                       "gain Kv of its position loop, for following errors; default: that of the controller"),
            number_key("velocity_feed_forward", unit_interval, "0.0",
                       "velocity feedforward of its loop, as a share of the speed"),
            number_key("acceleration_feed_forward", unit_interval, "0.0",
                       "feedforward for the acceleration because of velocity_lag_s, as a share"),
            number_key("velocity_lag_s", {.min = 1e-6, .max = 1, .allows_zero = true}, "0.0",
                       "time constant of its velocity loop"),
            number_key("command_delay_s", unit_interval, "0.0", "delay of the set points for its loop")};
}

std::vector<TableSchema> dynamics_schema() {
    return {{.at = {"dynamics"},
             .meaning = "computation of the forces and torques of the motors",
             .keys = {numbers_key("gravity_m_s2", 3, "in the world; default: [0.0, 0.0, -9.80665]"),
                      choice_key("limit", "\"axes\"", {"axes", "torque"},
                                 "limit of accelerations: those of the axes, or the peaks of the motors at "
                                 "the positions and speeds of each move")}},
            mass_table(),
            hose_table()};
}

}  // namespace gsim::machine
