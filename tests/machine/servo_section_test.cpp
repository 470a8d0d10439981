// Servo loops in machine files.

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::servo_section_test {
namespace {

/// A machine of one axis with these keys, from line 7 on.
std::string with(std::string_view keys, std::string_view controller = "") {
    return fmt::format(
        "[machine]\nname = \"m\"\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndirection = \"x\"\n{}\n{}\n",
        keys, controller);
}

std::string error_of(const std::string& toml) {
    const auto machine = read_machine(toml, "m.toml");
    return machine ? "no error" : machine.error().message;
}

TEST(ServoSection, ReadsAndPrintsAllKeys) {
    const Machine machine =
        read_machine(with("position_gain_1_s = 33.3\nvelocity_feed_forward = 0.9\nacceleration_feed_forward "
                          "= 0.8\nvelocity_lag_s = 0.002\ncommand_delay_s = 0.004"),
                     "m.toml")
            .value();
    EXPECT_EQ(machine.axes[0].servo, (Servo{.position_gain_1_s = 33.3,
                                            .velocity_feed_forward = 0.9,
                                            .acceleration_feed_forward = 0.8,
                                            .velocity_lag_s = 0.002,
                                            .command_delay_s = 0.004}));
    EXPECT_EQ(read_machine(print_machine(machine), "printed").value(), machine);
}

TEST(ServoSection, HasNoServoLoopWithoutKeys) {
    const Machine machine = read_machine(with(""), "m.toml").value();
    EXPECT_FALSE(machine.axes[0].servo);
    EXPECT_EQ(print_machine(machine).find("velocity_feed_forward"), std::string::npos);
}

// A loop that has but a key at its default is one all the same, and stays one when it is printed.
TEST(ServoSection, OneKeyDefinesServoLoop) {
    const Machine machine =
        read_machine(with("velocity_lag_s = 0.0", "[controller]\nposition_gain_1_s = 20.0"), "m.toml")
            .value();
    EXPECT_EQ(machine.axes[0].servo, Servo{});
    EXPECT_EQ(read_machine(print_machine(machine), "printed").value(), machine);
}

TEST(ServoSection, RejectsValuesOutOfRange) {
    EXPECT_EQ(error_of(with("position_gain_1_s = 0.5")),
              "m.toml:7:21: 'position_gain_1_s' must be 1 or greater; it is 0.5");
    EXPECT_EQ(error_of(with("position_gain_1_s = 30\nvelocity_feed_forward = 1.1")),
              "m.toml:8:25: 'velocity_feed_forward' must be from 0 to 1; it is 1.1");
    EXPECT_EQ(error_of(with("position_gain_1_s = 30\ncommand_delay_s = 2")),
              "m.toml:8:19: 'command_delay_s' must be from 0 to 1; it is 2");
    EXPECT_EQ(error_of(with("position_gain_1_s = 30\nvelocity_lag_s = -1")),
              "m.toml:8:18: 'velocity_lag_s' must be 0, or 1e-6 or greater, not -1");
}

TEST(ServoSection, RejectsLoopWithoutGain) {
    constexpr std::string_view kSentence =
        "the servo loop of axis X has no gain: set 'position_gain_1_s', 1 or greater, for the axis or in "
        "[controller]";
    EXPECT_NE(error_of(with("velocity_lag_s = 0.001")).find(kSentence), std::string::npos);
    EXPECT_NE(
        error_of(with("velocity_lag_s = 0.001", "[controller]\nposition_gain_1_s = 0.5")).find(kSentence),
        std::string::npos);
    EXPECT_EQ(error_of(with("velocity_lag_s = 0.001", "[controller]\nposition_gain_1_s = 5")), "no error");
}

}  // namespace
}  // namespace gsim::machine::servo_section_test
