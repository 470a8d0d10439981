#include "machine/file/controller_file.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/format.h"
#include "machine/file/machine_file.h"

namespace gsim::machine::controller_file_test {
namespace {

using rrs::ControllerRules;
using rrs::CornerRule;
using rrs::PlannerKind;

constexpr std::string_view kFileHeader = "[machine]\nname = \"m\"\n[controller]\n";  // three lines
constexpr std::string_view kAxis = "[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndh = {}\n";

// Returns a machine file with `lines` in its [controller], from line 4 on.
std::string with_controller(std::string_view lines) {
    return fmt::format("{}{}\n{}", kFileHeader, lines, kAxis);
}

ControllerRules read_rules(std::string_view lines) {
    return read_machine(with_controller(lines), "m.toml").value().controller;
}

std::string error_of(std::string_view lines, std::string_view file_name = "m.toml") {
    const auto machine = read_machine(with_controller(lines), file_name);
    return machine ? "no error" : machine.error().message;
}

std::string file_error_of(std::string_view toml) {
    const auto rules = read_controller(toml, "c.toml", "c");
    return rules ? "no error" : rules.error().message;
}

// Folder of its own, removed at the end of the test.
class CustomControllerFile : public testing::Test {
  protected:
    CustomControllerFile()
        : folder_(std::filesystem::path(testing::TempDir()) / "gsim_controller_file_test") {
        std::filesystem::create_directories(folder_);
    }
    ~CustomControllerFile() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, std::string_view text) const {
        std::ofstream(folder_ / name) << text;
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

  private:
    std::filesystem::path folder_;
};

TEST(ControllerFile, DefaultsToExactStopWithoutTable) {
    const Machine machine = read_machine(built_in_machine_toml(), "af5.toml").value();
    EXPECT_EQ(machine.controller, ControllerRules{});
    EXPECT_EQ(machine.controller.planner, PlannerKind::rest_to_rest);
    EXPECT_EQ(machine.controller.model, "exact-stop");
    EXPECT_EQ(read_rules(""), ControllerRules{});
    EXPECT_EQ(read_rules("model = \"exact-stop\""), ControllerRules{});
}

TEST(ControllerFile, EachKeyOverridesOneValueOfModel) {
    ControllerRules expected_value = built_in_controller("grbl-1.1").value();
    expected_value.blocks.look_ahead = 250;
    expected_value.corners.exact_path = CornerRule::stop;
    EXPECT_EQ(read_rules("look_ahead_blocks = 250.0\nexact_path_corner = \"stop\"\nmodel = \"grbl-1.1\""),
              expected_value);
}

// Each key has a value of its own, none of them a default. Exceptions are the orientation, which needs more
// of a machine, and independent_ramps, which needs another planner.
TEST(ControllerFile, EveryKeyIsReadAndPrinted) {
    const std::string lines =
        "name = \"all\"\nplanner = \"look-ahead\"\nlook_ahead_blocks = 7\ncorner = \"velocity-step\"\n"
        "exact_path_corner = \"junction-deviation\"\njunction_deviation_mm = 0.25\nspeed_step_s = 0.125\n"
        "stop_between_rapid_and_feed = false\nexact_path_stops = true\nlimit_jerk = "
        "true\ncentripetal_share "
        "= 0.5\ncontinuous_acceleration_share = 0.75\nblock_time_s = 0.004\n"
        "tcp_tolerance_mm = 0.02\narc_chord_tolerance_mm = 0.75\narc_resolution_mm = 0.5\n"
        "square_corner_velocity_mm_s = 6\nminimum_cruise_ratio = 0.25\nretract_length_mm = 1.5\n"
        "retract_speed_mm_s = 30\nunretract_extra_length_mm = 0.125\nunretract_speed_mm_s = 25\n"
        "inverse_time_of_chords = "
        "true\nmin_feed_mm_min = 3\nsettle_s = 4\n"
        "path_measure = \"all-axes\"\nfeed_measure = \"all-axes\"\nramp_step_s = 0.25\n"
        "spline_chord_tolerance_mm = 0.5\npeck_clearance_mm = 1.5\npeck_dwell_s = 2.5\n"
        "pecks_feed_down = true\nboring_cycles = false\n"
        "blend_tolerance_mm = 9\nblend_tolerance_deg = 10\nposition_gain_1_s = 11\nin_position_mm = 12\n"
        "in_position_deg = 13\nstandstill_s = 5\ndwell_step_s = 6\nservo_period_s = "
        "8\ncorner_override_percent = "
        "60\n"
        "corner_override_before_mm = 9\ncorner_override_after_mm = 10\ncorner_override_angle_deg = 120\n"
        "stops = { \"M1\" = \"never\", \"S\" = \"on-change\" }\n"
        "overrides = { feed_min_percent = 11, feed_max_percent = 190, rapid_max_percent = 90, "
        "rapid_percents = [20, 90], spindle_min_percent = 12, spindle_max_percent = 180, feed_of_probes = "
        "false, planned_feed_percent = 130, delay_s = 0.125 }";
    const ControllerRules expected_value{
        .model = "all",
        .planner = PlannerKind::look_ahead,
        .klipper = {.arc_resolution_mm = 0.5, .square_corner_velocity_mm_s = 6, .minimum_cruise_ratio = 0.25},
        .blocks = {.look_ahead = 7,
                   .time_s = 0.004,
                   .path_measure = rrs::PathMeasure::all_axes,
                   .feed_measure = rrs::PathMeasure::all_axes,
                   .min_feed_mm_min = 3},
        .corners = {.continuous = CornerRule::velocity_step,
                    .exact_path = CornerRule::junction_deviation,
                    .exact_path_stops = true,
                    .junction_deviation_mm = 0.25,
                    .blend_tolerance_mm = 9,
                    .blend_tolerance_deg = 10,
                    .speed_step_s = 0.125,
                    .stop_between_rapid_and_feed = false},
        .ramps = {.limit_jerk = true,
                  .step_s = 0.25,
                  .centripetal_share = 0.5,
                  .continuous_acceleration_share = 0.75},
        .curves = {.arc_chord_tolerance_mm = 0.75,
                   .spline_chord_tolerance_mm = 0.5,
                   .inverse_time_per_chord = true},
        .coordination = {.tcp_tolerance_mm = 0.02},
        .position_loop =
            {.servo_period_s = 8, .gain_1_s = 11, .in_position_mm = 12, .in_position_deg = 13, .settle_s = 4},
        .standstill = {.stops = {{"M1", rrs::StopRule::never}, {"S", rrs::StopRule::on_change}},
                       .dwell_s = 5,
                       .dwell_step_s = 6},
        .overrides = {.feed_min_percent = 11,
                      .feed_max_percent = 190,
                      .rapid_max_percent = 90,
                      .rapid_percents = {20, 90},
                      .spindle_min_percent = 12,
                      .spindle_max_percent = 180,
                      .delay_s = 0.125,
                      .override_probe_feed = false,
                      .planned_feed_percent = 130},
        .corner_override = {.percent = 60, .before_mm = 9, .after_mm = 10, .max_angle_deg = 120},
        .drilling = {.peck_clearance_mm = 1.5,
                     .peck_dwell_s = 2.5,
                     .pecks_feed_down = true,
                     .boring_cycles = false},
        .retraction = {.length_mm = 1.5,
                       .speed_mm_s = 30,
                       .unretract_extra_length_mm = 0.125,
                       .unretract_speed_mm_s = 25}};
    const Machine machine = read_machine(with_controller(lines), "m.toml").value();
    EXPECT_EQ(machine.controller, expected_value);
    EXPECT_EQ(read_machine(print_machine(machine), "printed").value(), machine) << print_machine(machine);
    EXPECT_EQ(read_controller("[controller]\n" + lines, "c.toml", "c").value(), expected_value);
}

TEST(ControllerFile, RejectsInvalidRangesOfOverrides) {
    const auto error_of_overrides = [](std::string_view entries) {
        return error_of(fmt::format("overrides = {{ {} }}", entries));
    };
    EXPECT_NE(
        error_of_overrides("feed_min_percent = 300").find("'feed_min_percent' is 300, above the maximum of "),
        std::string::npos);
    EXPECT_NE(error_of_overrides("rapid_max_percent = 101").find("'rapid_max_percent' must be"),
              std::string::npos);
    for (const std::string_view percents : {"3", "[50, 25]", "[0]", "[101]", "['a']"}) {
        EXPECT_NE(error_of_overrides(fmt::format("rapid_percents = {}", percents))
                      .find("'rapid_percents' must be an array of ascending numbers, above 0 and up to 100"),
                  std::string::npos)
            << percents;
    }
}

std::string great_circle(std::string_view lines, const Machine& like) {
    Machine machine = like;
    machine.controller = read_rules(lines);
    machine.controller.coordination.orientation = rrs::OrientationRule::great_circle;
    const auto read = read_machine(print_machine(machine), "m.toml");
    if (!read) return read.error().message;
    EXPECT_EQ(*read, machine);
    return "no error";
}

TEST(ControllerFile, GreatCircleOrientationNeedsHeadAndSuitablePlanner) {
    const Machine five = read_machine(built_in_machine_toml(), "af5.toml").value();
    EXPECT_EQ(read_rules("orientation = \"joints\""), ControllerRules{});
    EXPECT_EQ(great_circle("", five), "no error");
    EXPECT_EQ(great_circle("planner = \"look-ahead\"", five), "no error");
    EXPECT_THAT(great_circle("planner = \"linuxcnc\"", five),
                testing::HasSubstr("cannot be combined with the planners \"linuxcnc\""));
    EXPECT_THAT(great_circle("arc_chord_tolerance_mm = 0.01", five),
                testing::HasSubstr("or with arcs as chords"));
    EXPECT_THAT(error_of("orientation = \"great-circle\""),
                testing::AllOf(testing::HasSubstr("m.toml:3:"), testing::HasSubstr("two rotary axes")));
    EXPECT_THAT(error_of("orientation = \"slerp\""), testing::HasSubstr("great-circle"));
}

TEST(ControllerFile, IndependentRampsNeedRestToRestPlanner) {
    EXPECT_TRUE(read_rules("independent_ramps = true").coordination.independent_ramps);
    EXPECT_TRUE(
        read_rules("model = \"exact-stop\"\nindependent_ramps = true").coordination.independent_ramps);
    EXPECT_THAT(error_of("model = \"ab9\"\nindependent_ramps = true"),
                testing::AllOf(testing::HasSubstr("m.toml:3:"),
                               testing::HasSubstr("'independent_ramps' needs the planner \"rest-to-rest\"")));
}

TEST(ControllerFile, PercentageIsAboveZeroAndUpToHundred) {
    EXPECT_EQ(read_rules("corner_override_percent = 100").corner_override.percent, 100);
    for (const std::string_view value : {"0", "-1", "100.1", "inf"}) {
        EXPECT_NE(error_of(fmt::format("corner_override_percent = {}", value))
                      .find("'corner_override_percent' must be"),
                  std::string::npos)
            << value;
    }
}

TEST(ControllerFile, AcceptsUnlimitedCentripetalShareAndSpeedStep) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_EQ(read_rules("centripetal_share = inf").ramps.centripetal_share, inf);
    EXPECT_EQ(read_rules("centripetal_share = 5").ramps.centripetal_share, 5);
    EXPECT_EQ(read_rules("speed_step_s = inf").corners.speed_step_s, inf);
}

TEST(ControllerFile, PrintsModelAndDifferences) {
    const std::string printed =
        print_machine(read_machine(with_controller("model = \"ab9\"\nsettle_s = 0.02"), "m.toml").value());
    EXPECT_THAT(printed, testing::HasSubstr("\n[controller]\nmodel = \"ab9\"\nsettle_s = 0.02\n\n[[axis]]"));
    EXPECT_THAT(print_machine(read_machine(with_controller(""), "m.toml").value()),
                testing::Not(testing::HasSubstr("controller")));
}

TEST_F(CustomControllerFile, IsFoundInFolderOfMachineFile) {
    write("own.toml", "[controller]\nmodel = \"ab9\"\nsettle_s = 0.5\nstandstill_s = 0.25\n");
    write("machine.toml", with_controller("model = \"own.toml\"\nstandstill_s = 0.75"));
    ControllerRules expected_value = built_in_controller("ab9").value();
    expected_value.model = "own.toml";
    expected_value.position_loop.settle_s = 0.5;
    expected_value.standstill.dwell_s = 0.75;
    const auto machine = load_machine(path("machine.toml"));
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->controller, expected_value);
    EXPECT_EQ(read_machine(print_machine(*machine), "elsewhere.toml").value(), *machine)
        << "a printed machine must stand for itself";
}

TEST_F(CustomControllerFile, AcceptsAbsolutePath) {
    write("own.toml", "[controller]\nname = \"hall 4\"\n");
    const std::string lines = fmt::format("model = \"{}\"", path("own.toml"));
    EXPECT_EQ(read_rules(lines).model, "hall 4");
}

TEST_F(CustomControllerFile, ErrorsHaveSourceLocation) {
    write("own.toml", "[controller]\nsettle_s = -1\n");
    EXPECT_EQ(error_of("model = \"own.toml\"", path("m.toml")),
              path("own.toml") + ":2:12: 'settle_s' must be 0 or greater, not -1");
    EXPECT_EQ(error_of("model = \"none.toml\"", path("m.toml")),
              path("m.toml") + ":4:9: cannot read '" + path("none.toml") + "': No such file or directory");
    EXPECT_EQ(error_of("model = \"own.toml\\n.toml\""),
              "m.toml:4:9: 'model' must not contain control characters");
}

std::string built_in() {
    return text::joined(built_in_controllers(), ", ");
}

TEST_F(CustomControllerFile, RejectsFileAsModel) {
    write("own.toml", "[controller]\nmodel = \"own.toml\"\n");
    EXPECT_EQ(error_of("model = \"own.toml\"", path("m.toml")),
              path("own.toml") + ":2:9: 'model' of a controller file must be one of " + built_in());
}

TEST(ControllerFile, RejectsUnknownModels) {
    EXPECT_EQ(
        error_of("model = \"grbl1\""),
        "m.toml:4:9: unknown controller \"grbl1\"; did you mean \"grbl-1.1\"? built-in controllers are " +
            built_in() + "; the name of a controller file ends in .toml");
    EXPECT_EQ(error_of("model = \"siemens\\n840d\""),
              "m.toml:4:9: unknown controller \"siemens\\u000A840d\"; built-in controllers are " +
                  built_in() + "; the name of a controller file ends in .toml");
    EXPECT_EQ(error_of("model = 4"), "m.toml:4:9: 'model' must be a string, not a number");
}

TEST(ControllerFile, RejectsUnknownKeys) {
    EXPECT_EQ(error_of("look_ahead = 4"),
              "m.toml:4:1: unknown key 'look_ahead' in [controller]; did you mean 'look_ahead_blocks'?");
    EXPECT_THAT(error_of("x = 4"),
                testing::AllOf(testing::StartsWith("m.toml:4:1: unknown key 'x' in [controller]; known keys: "
                                                   "model, name, planner, "),
                               testing::HasSubstr(", corner, exact_path_corner, "),
                               testing::HasSubstr(", orientation, "),
                               testing::HasSubstr(", inverse_time_of_chords")));
}

TEST(ControllerFile, RejectsWrongTypes) {
    EXPECT_EQ(error_of("planner = \"look_ahead\""),
              "m.toml:4:11: 'planner' must be \"rest-to-rest\", \"look-ahead\", \"linuxcnc\" or \"klipper\"");
    EXPECT_EQ(error_of("corner = 4"),
              "m.toml:4:10: 'corner' must be \"stop\", \"velocity-step\", \"junction-deviation\", "
              "\"parabolic-blend\" or \"smooth-blend\"");
    EXPECT_EQ(error_of("exact_path_corner = \"Stop\""),
              "m.toml:4:21: 'exact_path_corner' must be \"stop\", \"velocity-step\", \"junction-deviation\", "
              "\"parabolic-blend\" or \"smooth-blend\"");
    EXPECT_EQ(error_of("limit_jerk = 1"), "m.toml:4:14: 'limit_jerk' must be true or false, not a number");
    EXPECT_EQ(error_of("standstill_s = true"),
              "m.toml:4:16: 'standstill_s' must be a number, not true or false");
    EXPECT_EQ(error_of("name = 4"), "m.toml:4:8: 'name' must be a string, not a number");
    EXPECT_EQ(read_machine("controller = 4\n[machine]\nname = \"m\"\n", "m.toml").error().message,
              "m.toml:1:14: 'controller' must be a table, not a number");
}

TEST(ControllerFile, RejectsValuesOutOfRange) {
    for (const std::string value : {"0", "-1", "2.5", "100001"}) {
        EXPECT_EQ(error_of("look_ahead_blocks = " + value),
                  "m.toml:4:21: 'look_ahead_blocks' must be an integer between 1 and 100000, not " + value);
    }
    for (const std::string value : {"0", "-0.5", "-inf"}) {
        EXPECT_EQ(error_of("centripetal_share = " + value),
                  "m.toml:4:21: 'centripetal_share' must be greater than 0, not " + value);
    }
    for (const std::string value : {"0", "1.5", "-0.5"}) {
        EXPECT_EQ(error_of("continuous_acceleration_share = " + value),
                  "m.toml:4:33: 'continuous_acceleration_share' must be greater than 0 and at most 1, not " +
                      value);
    }
    for (const std::string key : {"junction_deviation_mm", "blend_tolerance_mm", "blend_tolerance_deg",
                                  "min_feed_mm_min", "settle_s", "standstill_s"}) {
        const std::string location = fmt::format("m.toml:4:{}: '{}' must be ", key.size() + 4, key);
        EXPECT_EQ(error_of(key + " = -1"), location + "0 or greater, not -1");
        EXPECT_EQ(error_of(key + " = inf"), location + "finite, not inf");
        EXPECT_EQ(error_of(key + " = nan"), location + "a number, not nan");
        EXPECT_EQ(error_of(key + " = 1e300"), location + "between -1e9 and 1e9, not 1e+300");
    }
    for (const std::string key :
         {"arc_chord_tolerance_mm", "position_gain_1_s", "dwell_step_s", "servo_period_s"}) {
        const std::string location = fmt::format("m.toml:4:{}: '{}' must be ", key.size() + 4, key);
        EXPECT_EQ(error_of(key + " = 1e-9"), location + "0, or 1e-6 or greater, not 1e-09");
        EXPECT_EQ(error_of(key + " = -1"), location + "0, or 1e-6 or greater, not -1");
        EXPECT_EQ(error_of(key + " = inf"), location + "finite, not inf");
    }
    EXPECT_EQ(error_of("speed_step_s = 0"), "m.toml:4:16: 'speed_step_s' must be greater than 0, not 0");
    EXPECT_EQ(error_of("in_position_mm = 0"), "m.toml:4:18: 'in_position_mm' must be greater than 0, not 0");
}

TEST(ControllerFile, AcceptsOnlyControllerTable) {
    EXPECT_EQ(file_error_of(""), "c.toml:1:1: a controller file lacks the key 'controller'");
    EXPECT_EQ(file_error_of("controller = true\n"),
              "c.toml:1:14: 'controller' must be a table, not true or false");
    EXPECT_EQ(file_error_of("[machine]\nname = \"m\"\n"),
              "c.toml:1:2: unknown key 'machine' in a controller file; known keys: controller");
    EXPECT_EQ(file_error_of("[controller]\nstandstill = 1\n"),
              "c.toml:2:1: unknown key 'standstill' in [controller]; did you mean 'standstill_s'?");
    EXPECT_EQ(file_error_of("[controller\n").substr(0, 9), "c.toml:1:");
}

}  // namespace
}  // namespace gsim::machine::controller_file_test
