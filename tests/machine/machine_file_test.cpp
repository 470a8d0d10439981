#include "machine/file/machine_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/build_files/build_files.h"
#include "tests/support/machine_path.h"

namespace gsim::machine::machine_file_test {
namespace {

constexpr std::string_view kFileHeader = "[machine]\nname = \"m\"\n";  // two lines
constexpr std::string_view kAxis =
    "[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndh = {}\n";  // lines 3 to 6 after the head

std::string error_of(const std::string& toml) {
    const auto machine = read_machine(toml, "m.toml");
    return machine ? "no error" : machine.error().message;
}

std::string with_axis_line(std::string_view line) {
    return std::string(kFileHeader) + std::string(kAxis) + std::string(line) + "\n";  // that is line 7
}

std::vector<std::string> sample_machines() {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : tests::machine_files())
        names.push_back(file.filename().string());
    return names;
}

class SampleMachine : public testing::TestWithParam<std::string> {};

TEST_P(SampleMachine, ReadsAndPrintsBackEqual) {
    const auto machine = load_machine(tests::machine_path(GetParam()));
    ASSERT_TRUE(machine) << machine.error().message;
    const auto repeated = read_machine(print_machine(*machine), "printed");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine) << print_machine(*machine);
}

INSTANTIATE_TEST_SUITE_P(All, SampleMachine, testing::ValuesIn(sample_machines()), [](const auto& sample) {
    std::string name = sample.param;
    for (char& c : name) {
        if (c == '-' || c == '.') c = '_';
    }
    return name;
});

TEST(MachineFile, BuiltInMachineMatchesSpecification) {
    const Machine machine = read_machine(built_in_machine_toml(), "af5.toml").value();
    EXPECT_EQ(machine.name, "AF-series 5-axis waterjet gantry");
    EXPECT_EQ(machine.inverse, InverseKind::gantry);
    EXPECT_DOUBLE_EQ(machine.path.max_feed_mm_s, 600 * 25.4 / 60);
    EXPECT_NEAR(machine.path.max_acceleration_mm_s2, 0.05 * 9806.65, 0.01);
    ASSERT_EQ(machine.axes.size(), 5u);
    const Axis& y = machine.axes[1];
    EXPECT_EQ(y.letter, 'Y');
    EXPECT_DOUBLE_EQ(y.max, 8 * 304.8);
    EXPECT_DOUBLE_EQ(y.max_speed, 1200 * 25.4 / 60);
    const Axis& b = machine.axes[3];
    EXPECT_EQ(b.letter, 'B');
    EXPECT_EQ(b.kind, AxisKind::rotary);
    EXPECT_DOUBLE_EQ(b.min, -360);
    EXPECT_DOUBLE_EQ(b.max_speed, 90);
    EXPECT_DOUBLE_EQ(b.max_acceleration, 20);
}

TEST(MachineFile, BuiltInMachineEqualsSample) {
    const auto sample = load_machine(tests::source_path("samples/machines/af5.toml"));
    ASSERT_TRUE(sample) << sample.error().message;
    EXPECT_EQ(read_machine(built_in_machine_toml(), "").value(), *sample);
}

TEST(MachineFile, OmittedLimitsAreUnlimited) {
    const auto machine = read_machine(with_axis_line("max_mm = inf"), "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    const double inf = std::numeric_limits<double>::infinity();
    const Axis& axis = machine->axes[0];
    EXPECT_EQ(axis.min, -inf);
    EXPECT_EQ(axis.max, inf);
    EXPECT_EQ(axis.max_speed, inf);
    EXPECT_EQ(axis.max_acceleration, inf);
    EXPECT_EQ(axis.max_jerk, inf);
    EXPECT_EQ(axis.max_speed_step, inf);
    EXPECT_EQ(axis.step, 0);
    EXPECT_EQ(machine->path, PathLimits{});
    EXPECT_EQ(read_machine(print_machine(*machine), "").value(), *machine);
}

TEST(MachineFile, DecelerationDefaultsToAcceleration) {
    const auto own =
        read_machine(with_axis_line("max_acceleration_mm_s2 = 900\nmax_deceleration_mm_s2 = 400"), "m.toml");
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_EQ(own->axes[0].deceleration(), 400);
    EXPECT_EQ(read_machine(print_machine(*own), "").value(), *own);
    const auto same = read_machine(with_axis_line("max_acceleration_mm_s2 = 900"), "m.toml");
    ASSERT_TRUE(same) << same.error().message;
    EXPECT_EQ(same->axes[0].deceleration(), 900);
    EXPECT_FALSE(same->axes[0].max_deceleration.has_value());
}

TEST(MachineFile, ReadsJerkSpeedStepAndStepOfAxis) {
    const auto linear = read_machine(
        with_axis_line("max_jerk_mm_s3 = 5000\nmax_speed_step_mm_s = 2.5\nstep_mm = 0.004"), "m.toml");
    ASSERT_TRUE(linear) << linear.error().message;
    EXPECT_EQ(linear->axes[0].max_jerk, 5000);
    EXPECT_EQ(linear->axes[0].max_speed_step, 2.5);
    EXPECT_EQ(linear->axes[0].step, 0.004);
    EXPECT_EQ(read_machine(print_machine(*linear), "").value(), *linear);

    const auto rotary =
        read_machine(std::string(kFileHeader) +
                         "[[axis]]\nletter = \"B\"\nkind = \"rotary\"\ndh = {}\n"
                         "max_jerk_deg_s3 = 900\nmax_speed_step_deg_s = 0.5\nstep_deg = 1e-6\n",
                     "m.toml");
    ASSERT_TRUE(rotary) << rotary.error().message;
    EXPECT_EQ(rotary->axes[0].max_jerk, 900);
    EXPECT_EQ(rotary->axes[0].max_speed_step, 0.5);
    EXPECT_EQ(rotary->axes[0].step, 1e-6);
    EXPECT_EQ(read_machine(print_machine(*rotary), "").value(), *rotary);
}

TEST(MachineFile, AcceptsAnyCharacterInName) {
    Machine machine = read_machine(with_axis_line(""), "m.toml").value();
    machine.name = "a \"b\" \\ c\n\t\x01 \u00fc";
    const auto repeated = read_machine(print_machine(machine), "printed");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(repeated->name, machine.name);
}

TEST(MachineFile, UnknownKeySuggestsNearestKnownKey) {
    EXPECT_EQ(error_of("[machine]\nname = \"m\"\n[path]\nmax_feed = 4\n"),
              "m.toml:4:1: unknown key 'max_feed' in [path]; did you mean 'max_feed_mm_s'?");
    EXPECT_EQ(error_of(with_axis_line("min_deg = 0")),
              "m.toml:7:1: unknown key 'min_deg' in a linear [[axis]]; did you mean 'min_mm'?");
    EXPECT_EQ(error_of("[machine]\nname = \"m\"\ncolour = 4\n"),
              "m.toml:3:1: unknown key 'colour' in [machine]; known keys: name, inverse");
    EXPECT_EQ(error_of("[Machine]\n"),
              "m.toml:1:2: unknown key 'Machine' in a machine file; did you mean 'machine'?");
}

TEST(MachineFile, RejectsWrongTypes) {
    EXPECT_EQ(error_of(with_axis_line("min_mm = \"0\"")),
              "m.toml:7:10: 'min_mm' must be a number, not a string");
    EXPECT_EQ(error_of("[machine]\nname = 4\n"), "m.toml:2:8: 'name' must be a string, not a number");
    EXPECT_EQ(error_of("machine = 4\n"), "m.toml:1:11: 'machine' must be a table, not a number");
    EXPECT_EQ(error_of(std::string(kFileHeader) + "[axis]\n"),
              "m.toml:3:1: 'axis' must be an array of tables, each under [[axis]], not a table");
    EXPECT_EQ(error_of("axis = [ 4 ]\n" + std::string(kFileHeader)),
              "m.toml:1:10: 'axis' must contain only tables, each under [[axis]]");
    EXPECT_EQ(error_of("[machine]\nname = \"m\"\ninverse = \"robot\"\n"),
              "m.toml:3:11: 'inverse' must be \"none\", \"gantry\" or \"numeric\"");
    EXPECT_EQ(error_of(std::string(kFileHeader) + "[[axis]]\nkind = 4\n"),
              "m.toml:4:8: 'kind' must be \"linear\" or \"rotary\"");
}

TEST(MachineFile, ReportsMissingKeys) {
    EXPECT_EQ(error_of(""), "m.toml:1:1: a machine file lacks the key 'machine'");
    EXPECT_EQ(error_of("[machine]\n"), "m.toml:1:1: [machine] lacks the key 'name'");
    EXPECT_EQ(error_of(std::string(kFileHeader)), "m.toml:1:1: a machine file lacks the key 'axis'");
    EXPECT_EQ(error_of("axis = []\n" + std::string(kFileHeader)),
              "m.toml:1:8: a machine needs at least one [[axis]]");
    EXPECT_EQ(error_of(std::string(kFileHeader) + "[[axis]]\n"), "m.toml:3:1: [[axis]] lacks the key 'kind'");
    EXPECT_EQ(error_of(std::string(kFileHeader) + "[[axis]]\nkind = \"linear\"\n"),
              "m.toml:3:1: a linear [[axis]] lacks the key 'letter'");
    EXPECT_EQ(error_of(std::string(kFileHeader) + "[[axis]]\nkind = \"rotary\"\nletter = \"A\"\n"),
              "m.toml:3:1: a rotary [[axis]] needs one of the keys 'direction', 'frame' and 'dh', which "
              "define its joint");
}

TEST(MachineFile, RejectsValuesOutOfRange) {
    EXPECT_EQ(error_of(with_axis_line("max_speed_mm_s = -5")),
              "m.toml:7:18: 'max_speed_mm_s' must be greater than 0, not -5");
    EXPECT_EQ(error_of(with_axis_line("max_jerk_mm_s3 = 0")),
              "m.toml:7:18: 'max_jerk_mm_s3' must be greater than 0, not 0");
    EXPECT_EQ(error_of(with_axis_line("max_speed_step_mm_s = 0")),
              "m.toml:7:23: 'max_speed_step_mm_s' must be greater than 0, not 0");
    EXPECT_EQ(error_of(with_axis_line("step_mm = -0.1")),
              "m.toml:7:11: 'step_mm' must be 0, or 1e-6 or greater, not -0.1");
    EXPECT_EQ(error_of(with_axis_line("step_mm = 1e-7")),
              "m.toml:7:11: 'step_mm' must be 0, or 1e-6 or greater, not 1e-07");
    EXPECT_EQ(error_of(with_axis_line("step_mm = inf")), "m.toml:7:11: 'step_mm' must be finite, not inf");
    EXPECT_EQ(error_of(with_axis_line("min_mm = nan")), "m.toml:7:10: 'min_mm' must be a number, not nan");
    EXPECT_EQ(error_of(with_axis_line("home_mm = inf")), "m.toml:7:11: 'home_mm' must be finite, not inf");
    EXPECT_EQ(error_of(with_axis_line("max_mm = 1e300")),
              "m.toml:7:10: 'max_mm' must be between -1e9 and 1e9, not 1e+300");
    EXPECT_EQ(error_of(with_axis_line("min_mm = 20\nmax_mm = 10")),
              "m.toml:7:10: 'min_mm' is 20, greater than 'max_mm', 10");
    EXPECT_EQ(error_of(with_axis_line("min_mm = inf")), "m.toml:7:10: 'min_mm' and 'max_mm' leave no range");
    EXPECT_EQ(error_of(with_axis_line("max_mm = 10\nhome_mm = 11")),
              "m.toml:8:11: 'home_mm' is 11, outside the axis range -inf .. 10");
    EXPECT_EQ(error_of(with_axis_line("min_mm = 5")),
              "m.toml:3:1: 'home_mm' is 0, outside the axis range 5 .. inf");
}

TEST(MachineFile, RejectsInvalidAndDuplicateLetters) {
    EXPECT_EQ(error_of(std::string(kFileHeader) + "[[axis]]\nletter = \"F\"\nkind = \"linear\"\ndh = {}\n"),
              "m.toml:4:10: 'letter' must be one of A B C E U V W X Y Z");
    EXPECT_EQ(error_of(std::string(kFileHeader) + std::string(kAxis) + std::string(kAxis)),
              "m.toml:8:10: the letter X is given twice; first in line 4");
}

TEST(MachineFile, ReadsJointFromFrameOnWorkSide) {
    const auto machine = read_machine(std::string(kFileHeader) +
                                          "[work]\nz_mm = 5\n[[axis]]\nletter = \"C\"\nkind = \"rotary\"\n"
                                          "carries = \"work\"\nturning = \"unwind\"\nhome3_deg = 90\n"
                                          "frame = { x_mm = 1, y_mm = 2, yaw_deg = 180 }\n",
                                      "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    const Axis& axis = machine->axes.at(0);
    EXPECT_EQ(axis.carries, CarriedPart::work);
    EXPECT_EQ(axis.turning, RotaryMode::unwind);
    EXPECT_EQ(axis.frame, (Frame{.x_mm = 1, .y_mm = 2, .yaw_deg = 180}));
    EXPECT_EQ(axis.other_homes, (std::array<std::optional<double>, 3>{std::nullopt, 90.0, std::nullopt}));
    EXPECT_EQ(machine->work.z_mm, 5);
    EXPECT_EQ(read_machine(print_machine(*machine), "printed").value(), *machine);
}

TEST(MachineFile, RejectsInvalidJointsAndTurning) {
    EXPECT_EQ(error_of(with_axis_line("turning = \"shortest\"")).substr(0, 66),
              "m.toml:7:1: unknown key 'turning' in a linear [[axis]]; known keys");
    EXPECT_EQ(error_of(with_axis_line("carries = \"me\"")),
              "m.toml:7:11: 'carries' must be \"tool\", \"work\" or \"nothing\"");
    EXPECT_EQ(error_of(with_axis_line("max_mm = 10\nhome4_mm = 11")),
              "m.toml:8:12: 'home4_mm' is 11, outside the axis range -inf .. 10");
    const std::string rotary =
        std::string(kFileHeader) + "[[axis]]\nletter = \"A\"\nkind = \"rotary\"\ndh = {}\n";
    EXPECT_EQ(error_of(rotary + "turning = \"round\"\n"),
              "m.toml:7:11: 'turning' must be \"limited\", \"shortest\" or \"unwind\"");
    EXPECT_EQ(error_of(rotary + "turning = \"unwind\"\nmax_deg = 4\n"),
              "m.toml:7:11: an axis that unwinds turns without limit; remove 'min_deg' and 'max_deg'");
}

// If both are given, the frame is before the motion, and the row after it.
TEST(MachineFile, AppliesFrameBeforeDhRow) {
    const auto machine = read_machine(std::string(kFileHeader) +
                                          "[[axis]]\nletter = \"A\"\nkind = \"rotary\"\n"
                                          "frame = { y_mm = 3.0 }\ndh = { a_mm = 10.0 }\n",
                                      "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(read_machine(print_machine(*machine), "printed").value(), *machine);
    rrs::JointPos quarter(1);
    quarter << std::acos(0.0);
    const Eigen::Vector3d tcp = make_kinematics(*machine)->forward(quarter).translation();
    EXPECT_TRUE(tcp.isApprox(Eigen::Vector3d(0, 13, 0), 1e-12)) << tcp.transpose();
}

TEST(MachineFile, ReadsAxisFromDirection) {
    const auto machine = read_machine(std::string(kFileHeader) +
                                          "[[axis]]\nletter = \"A\"\nkind = \"rotary\"\ncarries = \"work\"\n"
                                          "frame = { z_mm = -25.0 }\ndirection = \"-x\"\n",
                                      "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->axes.at(0).direction, AxisDirection::minus_x);
    EXPECT_EQ(machine->axes.at(0).frame, (Frame{.z_mm = -25}));
    EXPECT_EQ(read_machine(print_machine(*machine), "printed").value(), *machine);
    EXPECT_EQ(error_of(with_axis_line("direction = \"x\"")),
              "m.toml:7:13: a linear [[axis]] has both 'dh' and 'direction'; only one may define its joint");
    EXPECT_EQ(error_of(std::string(kFileHeader) +
                       "[[axis]]\nletter = \"X\"\nkind = \"linear\"\ndirection = \"right\"\n"),
              "m.toml:6:13: 'direction' must be \"x\", \"y\", \"z\", \"-x\", \"-y\" or \"-z\"");
}

TEST(MachineFile, RejectsInverseUnfitForChain) {
    const std::string error =
        error_of("[machine]\nname = \"m\"\ninverse = \"gantry\"\n" + std::string(kAxis));
    EXPECT_EQ(error.substr(0, 13), "m.toml:3:11: ");
}

TEST(MachineFile, ReportsTomlSyntaxErrorsWithLocation) {
    EXPECT_EQ(error_of("[machine\n").substr(0, 11), "m.toml:1:9:");
    EXPECT_EQ(error_of("[machine]\nname = \"m\"\nname = \"n\"\n").substr(0, 9), "m.toml:3:");
    EXPECT_EQ(error_of("[machine]\nname = t\n").find('\n'), std::string::npos);
    EXPECT_EQ(error_of("[machine]\n\"na\\nme\" = 4\n"),
              "m.toml:2:1: unknown key 'na me' in [machine]; did you mean 'name'?");
}

TEST(MachineFile, ReportsUnreadableFile) {
    EXPECT_EQ(load_machine("no/such.toml").error().message,
              "cannot read 'no/such.toml': No such file or directory");
    EXPECT_EQ(load_machine(".").error().message, "cannot read '.': Is a directory");
}

}  // namespace
}  // namespace gsim::machine::machine_file_test
