// The S-curves of LinuxCNC 2.10.

#include <random>

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"

namespace gsim::motion::linuxcnc_curves_test {
namespace {

constexpr double kA = 1000, kV = 100, kPeriod_s = 1e-3;
constexpr double kEqualTolerance = 1 + 1e-3;  // cost of a period less at the end, for the remaining path

double ramp_s(double speed, double jerk) {
    return speed < kA * kA / jerk ? 2 * std::sqrt(speed / jerk) : speed / kA + kA / jerk;
}

// Returns the speed at which both ramps together have the length.
double peak(double length_mm, double jerk) {
    double low = 0, high = std::sqrt(kA * length_mm);
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (middle * ramp_s(middle, jerk) < length_mm ? low : high) = middle;
    }
    return low;
}

double rest_to_rest_s(double length_mm, double jerk) {
    const double reached = peak(length_mm, jerk);
    return reached < kV ? 2 * ramp_s(reached, jerk) : length_mm / kV + ramp_s(kV, jerk);
}

class LinuxcncSCurves : public testing::TestWithParam<double> {
  protected:
    double jerk() const { return GetParam(); }
};

INSTANTIATE_TEST_SUITE_P(Jerks, LinuxcncSCurves, testing::Values(5e3, 2e4, 1e6, 1e9));

// The time is a number of full periods; the last one is that in which no more than 1e-6 mm remains.
TEST_P(LinuxcncSCurves, RestToRestLineTakesFullServoPeriods) {
    const double creep_s = std::cbrt(6e-6 / jerk()) + std::sqrt(2e-6 / kA);
    for (const double length_mm : {0.01, 0.5, 10.0, 1000.0}) {
        LinuxcncRun run(router_2_10(jerk()));
        ASSERT_TRUE(run.line(length_mm, 0));
        const double duration_s = run.end();
        const double min_s = rest_to_rest_s(length_mm, jerk());
        EXPECT_GT(duration_s, min_s - creep_s) << length_mm;
        EXPECT_LT(duration_s, min_s + kPeriod_s) << length_mm;
        EXPECT_NEAR(std::remainder(duration_s, kPeriod_s), 0, 1e-9);
    }
}

TEST_P(LinuxcncSCurves, JunctionsOfChordsAreNoFasterThanSingleChord) {
    constexpr double kLength_mm = 0.5;
    LinuxcncRun run(router_2_10(jerk()));
    run.next.mode = rrs::PathMode::exact_path;
    for (int i = 1; i <= 60; ++i) ASSERT_TRUE(run.line(i * kLength_mm, 0));
    run.end();
    ASSERT_EQ(run.segments.size(), 60u);
    for (std::size_t i = 0; i + 1 < run.segments.size(); ++i) {
        const TimeLaw& law = run.segments[i].master;
        EXPECT_LE(law.end_speed(), peak(kLength_mm, jerk()) * kEqualTolerance);
        if (i + 2 < run.segments.size()) {
            EXPECT_NEAR(law.at(law.duration_s()).a, 0, 1e-3);
        }
    }
    EXPECT_NEAR(run.segments[30].master.end_speed(), peak(kLength_mm, jerk()), 1e-6);
}

TEST_P(LinuxcncSCurves, EntersLastLineAtBrakableSpeed) {
    for (const auto& [mode, share] :
         {std::pair{rrs::PathMode::exact_path, 1.0}, std::pair{rrs::PathMode::continuous, 0.5}}) {
        LinuxcncRun run(router_2_10(jerk()));
        run.next.mode = mode;
        ASSERT_TRUE(run.line(50, 0));
        ASSERT_TRUE(run.line(54, 0));
        run.end();
        const double speed = run.segments[0].master.end_speed();
        const double ramp = speed < share * share * kA * kA / jerk()
                                ? 2 * std::sqrt(speed / jerk())
                                : speed / (share * kA) + share * kA / jerk();
        EXPECT_NEAR(speed * ramp, 4, 1e-6);
    }
}

// Consecutive lines of all lengths and feeds, except for the last joint: LinuxCNC drops the jerk limit if it
// cannot reach the speed there.
TEST_P(LinuxcncSCurves, KeepLimitsAlongLines) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int program = 0; program < 40; ++program) {
        LinuxcncRun run(router_2_10(jerk()));
        run.next.mode = rrs::PathMode::exact_path;
        double x = 0;
        for (int i = 0; i < 30; ++i) {
            run.next.rules.programmed_speed_mm_s = 100 * unit(random) + 1;
            ASSERT_TRUE(run.line(x += std::pow(10, 3 * unit(random) - 1), 0));
        }
        ASSERT_TRUE(run.line(x += 1000, 0));
        run.end();
        expect_chain(run);
        double speed = 0;
        for (const Segment& segment : run.segments) {
            EXPECT_NEAR(segment.master.start_speed(), speed, 1e-4);
            speed = segment.master.end_speed();
            EXPECT_LE(segment.master.peak_speed(), segment.master_limits.max_speed * kEqualTolerance);
            EXPECT_LE(segment.master.peak_acceleration(), kA * kEqualTolerance);
            for (const LawSection& sub_segment : segment.master.sections())
                EXPECT_LE(std::abs(sub_segment.jerk), jerk() * kEqualTolerance);
        }
        EXPECT_NEAR(speed, 0, 1e-6);
    }
}

double circle_s(double radius_mm, double jerk, double feed_mm_s, double period_s) {
    LinuxcncRun run(router_2_10(jerk), period_s);
    run.next.rules.programmed_speed_mm_s = feed_mm_s;
    EXPECT_TRUE(run.arc(radius_mm, 0, 2 * kPi));
    return run.end();
}

// 20 mm/s at a jerk of 20000 and a radius of 20 mm, whatever the feed.
TEST(LinuxcncSCurvesOnArcs, ServoPeriodLimitsSpeed) {
    for (const double feed_mm_s : {30.0, 60.0, 100.0}) {
        for (const double period_s : {1e-3, 4e-3}) {
            const double speed = std::sqrt(20000 * 20 * period_s);
            const double top = std::min(speed, feed_mm_s);
            const double along = kA * std::sqrt(1 - std::pow(speed * speed / 20 / kA, 2));
            const double ramp =
                top < along * along / 20000 ? 2 * std::sqrt(top / 20000) : top / along + along / 20000;
            EXPECT_NEAR(circle_s(20, 20000, feed_mm_s, period_s), 2 * kPi * 20 / top + ramp, period_s);
        }
    }
}

TEST(LinuxcncSCurvesOnArcs, HugeJerkGivesTimeOfLinearRamps) {
    LinuxcncRun straight(router_2_10());
    ASSERT_TRUE(straight.arc(20, 0, 2 * kPi));
    EXPECT_NEAR(circle_s(20, 1e9, 100, kPeriod_s), straight.end(), 2 * kPeriod_s);
}

// A larger tolerance makes for a wider and slower arc: 12.1 s, 6.71 s and 5.01 s for a square of this kind.
TEST(LinuxcncSCurvesAtCorners, WiderBlendsAreSlower) {
    double last_s = 0;
    for (const double tolerance_mm : {0.05, 0.5, 0.0}) {
        LinuxcncRun run(router_2_10(5000));
        run.next.mode = rrs::PathMode::continuous;
        run.next.tolerance_mm = tolerance_mm;
        for (const auto& [x, y] : {std::pair{100, 0}, {100, 100}, {0, 100}, {0, 0}})
            ASSERT_TRUE(run.line(x, y));
        const double duration_s = run.end();
        EXPECT_GT(duration_s, last_s);
        last_s = duration_s;
    }
}

TEST(LinuxcncSCurvesOfRotaryAxes, RotaryAxisUsesItsJerkLimit) {
    LinuxcncRun run(router_2_10(5000));
    run.next.rules.orientation_speed_rad_s = 1;
    rrs::JointPos joints = run.next.start;
    joints[3] = 2;
    ASSERT_TRUE(run.go(joints));
    const double a = kPi / 0.9, jerk = 2000 * kPi / 180;
    const double ramp = 1 < a * a / jerk ? 2 * std::sqrt(1 / jerk) : 1 / a + a / jerk;
    EXPECT_NEAR(run.end(), 2 + ramp, kPeriod_s);
}

// This is as in LinuxCNC, which then does not limit the jerk of the complete move.
TEST(LinuxcncSCurvesOfRotaryAxes, OneAxisWithoutJerkLimitDisablesSCurve) {
    PlannerSetup setup = router_2_10(5000);
    setup.joints[1].max_jerk = kUnlimited;
    LinuxcncRun run(setup), straight(router_2_10()), curved(setup);
    ASSERT_TRUE(run.line(0, 80));
    ASSERT_TRUE(straight.line(0, 80));
    ASSERT_TRUE(curved.line(80, 0));
    EXPECT_EQ(run.end(), straight.end());
    EXPECT_NEAR(curved.end(), rest_to_rest_s(80, 5000), kPeriod_s);
}

TEST(LinuxcncSCurvesOfRotaryAxes, ParabolicBlendsNearlyStop) {
    double times_s[2];
    for (const auto mode : {rrs::PathMode::exact_stop, rrs::PathMode::continuous}) {
        LinuxcncRun run(router_2_10(20000));
        run.next.mode = mode;
        rrs::JointPos joints = run.next.start;
        for (int i = 0; i < 4; ++i) {
            joints[0] += 30;
            joints[3] += i % 2 == 0 ? 0.3 : -0.3;
            ASSERT_TRUE(run.go(joints));
        }
        times_s[mode == rrs::PathMode::continuous ? 1 : 0] = run.end();
        expect_chain(run);
    }
    EXPECT_LT(times_s[1], times_s[0]);
    EXPECT_GT(times_s[1], times_s[0] * 0.9);
}

// Down from 100 mm/s within the time of a ramp, and up again in as much.
TEST(LinuxcncSCurvesAndOverrides, FeedHoldFollowsSCurve) {
    PlannerSetup setup = router_2_10(20000);
    setup.overrides =
        std::make_shared<const OverrideSchedule>(std::vector<OverrideChange>{{1.0, {.feed = 0}}, {3.0, {}}});
    LinuxcncRun run(setup);
    ASSERT_TRUE(run.line(300, 0));
    const double ramp = ramp_s(kV, 20000);
    EXPECT_NEAR(run.end(), 300 / kV + ramp + (3.0 - 1.0), 2 * kPeriod_s);
    const auto speed_at = [&](double t_s) {
        for (const Segment& segment : run.segments)
            if (segment.end_s() >= t_s) return segment.path_speed_mm_s(t_s - segment.start_s);
        return 0.0;
    };
    EXPECT_NEAR(speed_at(1.0), kV, 1e-6);
    EXPECT_GT(speed_at(1.0 + ramp - kPeriod_s), 0);
    EXPECT_NEAR(speed_at(1.0 + ramp + kPeriod_s), 0, 1e-6);
    EXPECT_NEAR(speed_at(3.0 + ramp + kPeriod_s), kV, 1e-6);
    for (const Segment& segment : run.segments) {
        EXPECT_LE(segment.master.peak_acceleration(), kA * kEqualTolerance);
        for (const LawSection& sub_segment : segment.master.sections())
            EXPECT_LE(std::abs(sub_segment.jerk), 20000 * kEqualTolerance);
    }
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_curves_test
