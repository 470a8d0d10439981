// Moves that obey the operator's overrides, word by word. Accelerations are unlimited, so that each move
// takes its length by its speed.

#include <limits>
#include <string>
#include <vector>

#include "tests/lua_lib/ngc_run.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::overrides_test {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kRapid_mm_s = 508;

Conditions overridden(Conditions setup, const motion::Overrides& to) {
    setup.machine = built_in_machine();
    for (machine::Axis& axis : setup.machine.axes) {
        axis.min = -kUnlimited;
        axis.max = axis.max_acceleration = kUnlimited;
    }
    setup.machine.path.max_acceleration_mm_s2 = kUnlimited;
    setup.overrides = motion::OverrideSchedule({{0, to}});
    return setup;
}

constexpr motion::Overrides kHalf{.feed = 0.5, .rapid = 0.25, .spindle = 0.8};

Outcome run_ab9(const std::string& program) {
    return run(program, overridden({}, kHalf));
}

Outcome run_linuxcnc(const std::string& program) {
    return run_ngc(program, overridden(ngc_conditions(), kHalf));
}

/// Returns the share of its speed that a feed of 100 mm at F600, or a rapid, has after `words`.
double feed_share(const Outcome& r, std::size_t n = 0) {
    return 10 / r.seconds(n);
}
double rapid_share(const Outcome& r, std::size_t n = 0) {
    return 100 / kRapid_mm_s / r.seconds(n);
}

struct Lock {
    const char* words;
    double feed;
    double rapid;
    double by_spindle;  ///< Share for a feed of 1 mm a turn at S600.
};

// LinuxCNC: the enables of a move are those at its programming; FS_ENABLED is that of feeds and rapids.
TEST(OverrideLocks, FollowLinuxcncWords) {
    for (const Lock& lock :
         {Lock{"", 0.5, 0.25, 0.4}, Lock{"M49", 1, 1, 1}, Lock{"M49 \nM48", 0.5, 0.25, 0.4},
          Lock{"M50 P0", 1, 1, 0.8}, Lock{"M50 P0\nM50", 0.5, 0.25, 0.4},
          Lock{"M50 P0\nM50 P1", 0.5, 0.25, 0.4}, Lock{"M51 P0", 0.5, 0.25, 0.5},
          Lock{"M51 P0\nM51 P1", 0.5, 0.25, 0.4}, Lock{"M51 P0\nM50 P0", 1, 1, 1},
          Lock{"M52 P1", 0.5, 0.25, 0.4}, Lock{"M53 P0", 0.5, 0.25, 0.4}, Lock{"M49\nM50", 0.5, 0.25, 0.5},
          Lock{"M49\nM51", 1, 1, 0.8}, Lock{"M70\nM49\nM72", 0.5, 0.25, 0.4}}) {
        const std::string begin = "G21 G90 S600 M3\n" + std::string(lock.words) + "\n";
        const Outcome r = run_linuxcnc(begin + "G1 X100 F600\nG0 X0\nG95 G1 X100 F1\nM2\n");
        ASSERT_EQ(r.moves.size(), 3U) << lock.words << r.message();
        EXPECT_NEAR(feed_share(r), lock.feed, 1e-9) << lock.words;
        EXPECT_NEAR(rapid_share(r, 1), lock.rapid, 1e-9) << lock.words;
        EXPECT_NEAR(feed_share(r, 2), lock.by_spindle, 1e-9) << lock.words;
    }
}

TEST(OverrideLocks, FollowAb9Words) {
    for (const Lock& lock :
         {Lock{"", 0.5, 0.25, 0.4}, Lock{"M49", 1, 1, 1}, Lock{"M49\nM48", 0.5, 0.25, 0.4},
          Lock{"G63", 1, 0.25, 0.8}, Lock{"G63\nG64", 0.5, 0.25, 0.4}, Lock{"G63\nG61", 0.5, 0.25, 0.4},
          Lock{"M49\nG63\nM48", 1, 0.25, 0.8}, Lock{"G63\nM49\nG64", 1, 1, 1}}) {
        const Outcome r =
            run_ab9("S600 M3\n" + std::string(lock.words) + "\nG1 X100 F600\nG0 X0\nG95 G1 X100 F1\n");
        ASSERT_EQ(r.moves.size(), 3U) << lock.words << r.message();
        EXPECT_NEAR(feed_share(r), lock.feed, 1e-9) << lock.words;
        EXPECT_NEAR(rapid_share(r, 1), lock.rapid, 1e-9) << lock.words;
        EXPECT_NEAR(feed_share(r, 2), lock.by_spindle, 1e-9) << lock.words;
    }
}

TEST(OverrideLocks, InverseTimeFeedIsScaled) {
    EXPECT_NEAR(run_linuxcnc("G21 G90 G93\nG1 X100 F6\nM2\n").seconds(0), 20, 1e-9);
    EXPECT_NEAR(run_ab9("G93\nG1 X100 F6\n").seconds(0), 20, 1e-9);
    EXPECT_TRUE(run_linuxcnc("G21 G90 G93\nG1 X100 F6\nM2\n").report.messages.warnings.empty());
}

// In step with the spindle: its override makes them slower, that of the feed does not.
TEST(OverrideLocks, LinuxcncThreadsFollowOnlySpindleOverride) {
    const Outcome r = run_linuxcnc("G21 G90 S600 M3\nG33 Z-100 K1\nG0 Z0\nM51 P0\nG33.1 Z-100 K1\nM2\n");
    ASSERT_GE(r.moves.size(), 4U) << r.message();
    EXPECT_NEAR(feed_share(r, 0), 0.8, 1e-9);
    EXPECT_NEAR(feed_share(r, 2), 1, 1e-9);
    EXPECT_NEAR(feed_share(r, 3), 1, 1e-9);
    EXPECT_NEAR(r.report.overrides->feed_locked_s, 12.5 + 20, 1e-9);
    EXPECT_NEAR(r.report.overrides->spindle_locked_s, 20, 1e-9);
}

TEST(OverrideLocks, Ab9ThreadsIgnoreOverrides) {
    const Outcome thread = run_ab9("S600 M3\nG33 Z-100 F1\nG1 Z0 F600\n");
    EXPECT_NEAR(feed_share(thread, 0), 1, 1e-9);
    EXPECT_NEAR(feed_share(thread, 1), 0.5, 1e-9) << "what follows obeys again";
}

/// The times of all moves of 100 mm that are no rapids.
std::vector<double> strokes_s(const Outcome& r) {
    std::vector<double> times;
    for (std::size_t n = 0; n < r.moves.size(); ++n) {
        if (r.moves[n].info.kind == simulation::MoveKind::linear) times.push_back(r.seconds(n));
    }
    return times;
}

TEST(OverrideLocks, TapsIgnoreOverrides) {
    const Outcome ngc =
        run_linuxcnc("G21 G90 G98 S600 M3 F600\nG0 Z0\nG84 X0 Y0 Z-100 R0\nG80\nG1 X100\nM2\n");
    EXPECT_TRUE(ngc.completed()) << ngc.message();
    const std::vector<double> of_ngc = strokes_s(ngc);
    ASSERT_EQ(of_ngc.size(), 3U);
    EXPECT_NEAR(of_ngc[0], 10, 1e-9);
    EXPECT_NEAR(of_ngc[1], 10, 1e-9);
    EXPECT_NEAR(of_ngc[2], 20, 1e-9);
    const Outcome ab9 = run_ab9("S600 M3 F600\nG0 Z0\nG84 X0 Y0 Z-100 R0\nG80\nG1 X100\n");
    const std::vector<double> of_ab9 = strokes_s(ab9);
    ASSERT_EQ(of_ab9.size(), 3U) << ab9.message();
    EXPECT_NEAR(of_ab9[0], 10, 1e-9);
    EXPECT_NEAR(of_ab9[2], 20, 1e-9);
}

TEST(OverrideLocks, ProbesFollowFeedOverrideIfEnabled) {
    Conditions setup = overridden(ngc_conditions(), kHalf);
    setup.probe.kind = simulation::ProbeSurface::Kind::none;
    const std::string program = "G21 G90 F600\nG38.3 X100\nM2\n";
    EXPECT_NEAR(feed_share(run_ngc(program, setup)), 0.5, 1e-9);
    setup.machine.controller.overrides.override_probe_feed = false;
    const Outcome grbl = run_ngc(program, setup);
    EXPECT_NEAR(feed_share(grbl), 1, 1e-9);
    EXPECT_NEAR(grbl.report.overrides->feed_locked_s, 10, 1e-9);
}

TEST(OverrideLocks, DwellsIgnoreOverrides) {
    const Outcome r = run_linuxcnc("G21 G90\nG4 P3\nM2\n");
    EXPECT_NEAR(r.report.cycle_time_s, 3, 1e-9);
}

TEST(OverrideLocks, ReportContainsLockedTimes) {
    const Outcome r = run_linuxcnc("G21 G90 F600\nM49\nG1 X100\nG0 X0\nM48\nG1 X100\nM2\n");
    ASSERT_TRUE(r.report.overrides);
    EXPECT_NEAR(r.report.overrides->feed_locked_s, 10, 1e-9);
    EXPECT_NEAR(r.report.overrides->rapid_locked_s, 100 / kRapid_mm_s, 1e-9);
    EXPECT_EQ(r.report.overrides->spindle_locked_s, 0);
    EXPECT_EQ(r.report.overrides->changes, (std::vector<motion::OverrideChange>{{0, kHalf}}));
    EXPECT_FALSE(run_ngc("G21 F600\nM49\nG1 X10\nM2\n").report.overrides);
}

TEST(OverrideLocks, ControllerDelaysOverrideChange) {
    Conditions setup = overridden(ngc_conditions(), {});
    setup.overrides = motion::OverrideSchedule({{2, {.feed = 0.5}}});
    const std::string program = "G21 G90 F600\nG1 X100\nM2\n";
    EXPECT_NEAR(run_ngc(program, setup).report.cycle_time_s, 2 + 16, 1e-6);
    setup.machine.controller.overrides.delay_s = 0.5;
    const Outcome later = run_ngc(program, setup);
    EXPECT_NEAR(later.report.cycle_time_s, 2.5 + 15, 1e-6);
    EXPECT_EQ(later.report.overrides->changes.front().at_s, 2) << "as the operator turned it";
}

}  // namespace
}  // namespace gsim::script::overrides_test
