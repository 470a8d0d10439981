// Statements in machine files about the uncertainty of their values.

#include <string>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "machine/model/machine_parameter.h"

namespace gsim::machine::calibration_section_test {
namespace {

constexpr std::string_view kMachine = R"([machine]
name = "m"
[controller]
planner = "look-ahead"
[[axis]]
letter = "X"
kind = "linear"
max_acceleration_mm_s2 = 500
direction = "x"
[[axis]]
letter = "B"
kind = "rotary"
max_acceleration_deg_s2 = 90
direction = "y"
)";

std::string with(const std::string& lines) {
    return std::string(kMachine) + lines;
}

std::string error_of(const std::string& lines) {
    const auto machine = read_machine(with(lines), "m.toml");
    return machine ? "no error" : machine.error().message;
}

std::string parameter_id(const std::string& of, const std::string& key, const std::string& row) {
    return "[[calibrated]]\nof = \"" + of + "\"\nkey = \"" + key + "\"\ncovariance_percent2 = " + row + "\n";
}

TEST(CalibrationSection, IsReadAndPrintedBack) {
    const auto machine = read_machine(with("[calibration]\nruns = 12\nresidual_percent = 0.25\n" +
                                           parameter_id("X", "max_acceleration_mm_s2", "[4, 1]") +
                                           parameter_id("controller", "speed_step_s", "[1, 9]")),
                                      "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    const Calibration expected_value{
        .runs = 12,
        .residual_percent = 0.25,
        .parameters = {{"X", "max_acceleration_mm_s2"}, {"controller", "speed_step_s"}},
        .covariance_percent2 = {{4, 1}, {1, 9}}};
    EXPECT_EQ(machine->calibration, expected_value);
    const auto repeated = read_machine(print_machine(*machine), "m.toml");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine);
}

TEST(CalibrationSection, AcceptsTimesOfWordsAsParameters) {
    const auto machine = read_machine(
        with("[times]\ntool_change_s = 6\nM100 = 2\n[calibration]\nruns = 5\n" +
             parameter_id("times", "tool_change_s", "[4, 0]") + parameter_id("times", "M100", "[0, 1]")),
        "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(parameter_value({"times", "tool_change_s"}, *machine), 6);
    EXPECT_EQ(parameter_value({"times", "M100"}, *machine), 2);
    EXPECT_FALSE(parameter_value({"times", "M101"}, *machine));
    Machine other = *machine;
    set_value({"times", "M100"}, 3, other);
    EXPECT_EQ(other.times.codes_s.at(100), 3);
    EXPECT_EQ(read_machine(print_machine(*machine), "m.toml").value(), *machine);
}

TEST(CalibrationSection, RejectsInvalidCalibrations) {
    const std::string head = "[calibration]\nruns = 2\n";
    EXPECT_NE(error_of(parameter_id("X", "max_acceleration_mm_s2", "[1]")).find("[calibration] is missing"),
              std::string::npos);
    EXPECT_NE(
        error_of(head + parameter_id("X", "max_acceleration_mm_s2", "[1, 2]")).find("covariance_percent2"),
        std::string::npos);
    EXPECT_NE(error_of(head + parameter_id("X", "max_acceleration_mm_s2", "[-1]"))
                  .find("'covariance_percent2' are not a covariance"),
              std::string::npos);
    EXPECT_NE(error_of(head + parameter_id("X", "max_acceleration_mm_s2", "[1, 5]") +
                       parameter_id("controller", "speed_step_s", "[5, 1]"))
                  .find("'covariance_percent2' are not a covariance"),
              std::string::npos);
    for (const auto& [of, key] :
         {std::pair{"Q", "max_acceleration_mm_s2"}, std::pair{"X", "max_acceleration_deg_s2"},
          std::pair{"path", "speed_step_s"}, std::pair{"", "speed_step_s"},
          std::pair{"XB", "max_acceleration_mm_s2"}}) {
        EXPECT_NE(error_of(head + parameter_id(of, key, "[1]")).find("cannot be calibrated"),
                  std::string::npos)
            << of << key;
    }
}

TEST(MachineParameter, ReadsAndSetsValueInUnitsOfFile) {
    Machine machine = read_machine(kMachine, "m.toml").value();
    EXPECT_EQ(parameter_value({"B", "max_acceleration_deg_s2"}, machine), 90);
    set_value({"controller", "speed_step_s"}, 0.5, machine);
    EXPECT_EQ(machine.controller.corners.speed_step_s, 0.5);
    EXPECT_EQ(parameter_name({"XY", "max_jerk_mm_s3"}), "axes X, Y: max_jerk_mm_s3");
    EXPECT_EQ(parameter_name({"path", "max_feed_mm_s"}), "path: max_feed_mm_s");
}

}  // namespace
}  // namespace gsim::machine::calibration_section_test
