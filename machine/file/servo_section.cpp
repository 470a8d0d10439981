#include "machine/file/servo_section.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace gsim::machine {

namespace {

using base::NumberRule;
using base::TomlSection;

constexpr std::string_view kGainKey = "position_gain_1_s";
constexpr double kMinGain_1_s = 1;

/// A key with a value from 0 to 1: a share, or seconds.
struct ServoKey {
    std::string_view key;
    double Servo::*value;
    NumberRule rule = NumberRule::not_negative;
};

constexpr std::array kUnitIntervalKeys{
    ServoKey{"velocity_feed_forward", &Servo::velocity_feed_forward},
    ServoKey{"acceleration_feed_forward", &Servo::acceleration_feed_forward},
    ServoKey{"velocity_lag_s", &Servo::velocity_lag_s, NumberRule::step},
    ServoKey{"command_delay_s", &Servo::command_delay_s}};

}  // namespace

std::vector<std::string_view> servo_keys() {
    std::vector<std::string_view> keys{kGainKey};
    for (const ServoKey& key : kUnitIntervalKeys) keys.push_back(key.key);
    return keys;
}

std::optional<Servo> read_servo(TomlSection& axis) {
    const std::vector<std::string_view> keys = servo_keys();
    if (std::none_of(keys.begin(), keys.end(), [&](std::string_view key) { return axis.has(key); }))
        return std::nullopt;
    Servo servo;
    servo.position_gain_1_s = axis.number(kGainKey, 0, NumberRule::not_negative);
    if (axis.has(kGainKey) && servo.position_gain_1_s < kMinGain_1_s)
        axis.fail(kGainKey,
                  fmt::format("'{}' must be 1 or greater; it is {}", kGainKey, servo.position_gain_1_s));
    for (const ServoKey& key : kUnitIntervalKeys) {
        const double value = axis.number(key.key, 0, key.rule);
        if (value > 1) axis.fail(key.key, fmt::format("'{}' must be from 0 to 1; it is {}", key.key, value));
        servo.*key.value = value;
    }
    return servo;
}

void print_servo(base::TomlWriter& out, const Axis& axis) {
    if (!axis.servo) return;
    // It is written even if it has no effect, because the keys define that a loop exists.
    if (axis.servo->position_gain_1_s > 0) out.number(kGainKey, axis.servo->position_gain_1_s);
    out.number("velocity_feed_forward", axis.servo->velocity_feed_forward);
    for (const ServoKey& key : kUnitIntervalKeys) {
        if (key.value != &Servo::velocity_feed_forward && axis.servo.value().*key.value != 0)
            out.number(key.key, axis.servo.value().*key.value);
    }
}

std::optional<Error> find_servo_error(const Machine& machine) {
    const double gain_1_s = machine.controller.position_loop.gain_1_s;
    if (gain_1_s >= kMinGain_1_s) return std::nullopt;
    for (const Axis& axis : machine.axes) {
        if (!axis.servo || axis.servo->position_gain_1_s > 0) continue;
        return fmt::format(
            "the servo loop of axis {} has no gain: set '{}', 1 or greater, for the axis or in [controller]",
            axis.letter, kGainKey);
    }
    return std::nullopt;
}

}  // namespace gsim::machine
