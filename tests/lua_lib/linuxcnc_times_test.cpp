// Short programs against the times that LinuxCNC 2.9 took for them (the unpatched Debian package, counted in
// servo periods of 1 ms), on machines with its limits.

#include <string>

#include <fmt/format.h>

#include "tests/build_files/build_files.h"
#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::linuxcnc_times_test {
namespace {

constexpr double kNear_s = 0.002;  // the phase of a motion's start in a period is random

struct Recorded {
    const char* name;
    const char* program;
    double time_s;
};

class LinuxcncTimes : public testing::TestWithParam<Recorded> {};

TEST_P(LinuxcncTimes, MatchRecordedTimes) {
    Conditions setup = ngc_conditions();
    setup.machine = machine::load_machine(
                        std::filesystem::path(tests::source_path("samples/machines/linuxcnc-router.toml")))
                        .value();
    const Outcome run = run_ngc(std::string("G21 G90 G94 G17\n") + GetParam().program + "M2\n", setup);
    ASSERT_TRUE(run.completed()) << run.message();
    EXPECT_NEAR(run.report.cycle_time_s, GetParam().time_s, kNear_s);
    EXPECT_EQ(run.moves.back().end_s, run.report.cycle_time_s);  // with the periods in which the axes follow
}

std::string test_name(const testing::TestParamInfo<Recorded>& recorded) {
    return recorded.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Turns, LinuxcncTimes,
    testing::Values(
        Recorded{"four", "G64 P0.05\nG1 Z5 F2000\nG1 Z0\nG2 X0 Y0 Z-4 I5 J0 P4 F4000\nG1 X10\n", 2.976},
        Recorded{"two", "G64 P0.05\nG1 Z5 F2000\nG1 Z0\nG2 X0 Y0 Z-4 I5 J0 P2 F4000\nG1 X10\n", 1.922}),
    test_name);

/// No blend arc leads into a helix from an arc or out of it.
INSTANTIATE_TEST_SUITE_P(
    Helices, LinuxcncTimes,
    testing::Values(Recorded{"behind_an_arc",
                             "G64\nG1 F4000 X0 Y-2\nX0 Y0\nG2 X0 Y0 I-0.35 J0\nG3 X0 Y0 Z0.7 I0 J3.25\n",
                             0.957},
                    Recorded{"behind_turns",
                             "G64\nG19\nG1 F4000 Y-1.4480 Z1.0160\nG2 Y-1.4480 Z1.0160 J-0.3437 K0 P3\n"
                             "G3 X0.7 Y-1.4480 Z1.0160 J0 K3.2548 P3\n",
                             1.940}),
    test_name);

/// For rotary axes alone the tolerance counts in degrees, and they move along X for the angle of a corner.
INSTANTIATE_TEST_SUITE_P(
    RotaryAxes, LinuxcncTimes,
    testing::Values(Recorded{"before_a_line", "G64 P0.05\nG1 B15 F2000\nG1 B30\nG1 X-10\n", 1.557},
                    Recorded{"between_lines", "G64 P0.05\nG1 X10 F2000\nG1 B15\nG1 X20\n", 1.152}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Splines, LinuxcncTimes,
    testing::Values(
        Recorded{"cubic", "G64\nG1 X5 F3000\nG5 I5 J10 P-5 Q10 X25 Y0\nG5 X45 Y0 P-5 Q10\nG1 X100\n", 2.345},
        Recorded{"quadratic",
                 "G64 P0.02\nG1 X5 F3000\nG5.1 X15 Y0 I5 J-8\nG5.1 X25 Y0 I5 J8\nG5.1 X35 Y0 I5 J-8\n"
                 "G5.1 X45 Y0 I5 J8\nG5.1 X55 Y0 I5 J-8\nG5.1 X65 Y0 I5 J8\nG5.1 X75 Y0 I5 J-8\n"
                 "G5.1 X85 Y0 I5 J8\nG1 X100\n",
                 2.701}),
    test_name);

double feed_mm(const std::string& feed) {
    Conditions setup = ngc_conditions();
    setup.machine = machine::load_machine(
                        std::filesystem::path(tests::source_path("samples/machines/linuxcnc-router.toml")))
                        .value();
    const Outcome run = run_ngc("G21 G90 G17 G64 M3 S1000\n" + feed + "G1 X40\nY40\nX0\nM2\n", setup);
    EXPECT_TRUE(run.completed()) << run.message();
    return run.report.distances.feed_mm;
}

/// The speed that the spindle will require is not known, so that corners are rounded for the limits of the
/// machine.
TEST(LinuxcncSpindleFeed, RoundsCornersForMaxSpeed) {
    const double over_time = feed_mm("G94 F300\n");
    const double by_turns = feed_mm("G95 F0.3\n");
    // At 5 mm/s an arc of less than 0.1 mm is wide enough; each one shortens the path by (2 - pi/2) of its
    // radius.
    EXPECT_GT(over_time, 120 - 0.1);
    EXPECT_LT(by_turns, 120 - 2);
}

}  // namespace
}  // namespace gsim::script::linuxcnc_times_test
