// Lag of a position loop, compared with a numerical integration of its equation.
#include "motion/profile/following_error.h"

#include "tests/motion/look_ahead_path.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::following_error_test {
namespace {

/// e' = v(t) - gain e by the classical Runge-Kutta method.
double integrated_lag(const TimeLaw& law, double lag, double gain_1_s) {
    double from_s = 0;
    for (const LawSection& section : law.sections()) {
        constexpr int kSteps = 4000;
        const double h = section.duration_s / kSteps;
        const auto slope = [&](double t, double e) {
            return section.v0 + t * (section.a0 + t * section.jerk / 2) - gain_1_s * e;
        };
        for (int i = 0; i < kSteps; ++i) {
            const double t = i * h;
            const double k1 = slope(t, lag);
            const double k2 = slope(t + h / 2, lag + h / 2 * k1);
            const double k3 = slope(t + h / 2, lag + h / 2 * k2);
            const double k4 = slope(t + h, lag + h * k3);
            lag += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        from_s += section.duration_s;
    }
    EXPECT_NEAR(from_s, law.duration_s(), 1e-12);
    return lag;
}

TEST(FollowingError, AgreesWithNumericalIntegration) {
    std::mt19937 random(41);
    std::uniform_real_distribution<double> log_scale(-2, 2);
    for (int run = 0; run < 40; ++run) {
        const double jerk = run % 2 == 0 ? kUnlimited : 1e4 * std::exp(log_scale(random));
        const LawLimits limits{100 * std::exp(log_scale(random)), 1000 * std::exp(log_scale(random)),
                               1000 * std::exp(log_scale(random)), jerk};
        const TimeLaw law = TimeLaw::between(20 * std::exp(log_scale(random)), 0, 0, limits);
        const double gain_1_s = 20 * std::exp(2 * log_scale(random));
        const double lag = std::exp(log_scale(random));
        const double expected_value = integrated_lag(law, lag, gain_1_s);
        EXPECT_NEAR(lag_after(law, lag, gain_1_s), expected_value, 1e-7 * (1 + expected_value)) << run;
    }
}

/// After a long cruise and a ramp down at the deceleration a, the error is a / gain^2 (1 - exp(-gain t)).
TEST(FollowingError, MatchesClosedFormAfterRampDown) {
    const double gain_1_s = 33.3;
    const TimeLaw law = TimeLaw::between(1000, 0, 0, {100, 500, 500});
    const double ramp_s = 100.0 / 500;
    EXPECT_NEAR(lag_after(law, 0, gain_1_s), 500 / (gain_1_s * gain_1_s) * (1 - std::exp(-gain_1_s * ramp_s)),
                1e-9);
}

PlannerSetup loop_setup() {
    PlannerSetup setup = router_setup();
    setup.controller.position_loop.gain_1_s = 20;
    setup.controller.position_loop.in_position_mm = 0.01;
    return setup;
}

TEST(FollowingError, ExactStopWaitsUntilErrorIsInBand) {
    PlannerSetup setup = loop_setup();
    setup.controller.position_loop.settle_s = 0.125;
    Path path(setup);
    path.mode = rrs::PathMode::exact_stop;
    path.line(300, 0);
    path.line(300, 0.001);
    path.standstill();
    ASSERT_EQ(path.out().segments.size(), 4U);
    const double lag_mm = 1000.0 / 400 * (1 - std::exp(-20 * 0.1));
    EXPECT_FALSE(path.out().segments[0].reaches_target);
    EXPECT_EQ(path.out().segments[1].kind, SegmentKind::rest);
    EXPECT_TRUE(path.out().segments[1].reaches_target);
    EXPECT_NEAR(path.out().segments[1].duration_s, 0.125 + std::log(lag_mm / 0.01) / 20, 1e-9);
    // The remainder of the error is within the band, and the short path adds almost no time.
    EXPECT_NEAR(path.out().segments[3].duration_s, 0.125, 1e-9);
}

TEST(FollowingError, RotaryJointHasOwnShareAndBand) {
    PlannerSetup setup = loop_setup();
    setup.joints.push_back({rrs::JointKind::revolute});
    setup.controller.position_loop.in_position_deg = 0.001;
    Path path(setup);
    path.mode = rrs::PathMode::exact_stop;
    path.line(joint_pos({300, 0, 0, 1.5}));
    path.standstill();
    const double lag_mm = 1000.0 / 400 * (1 - std::exp(-20 * 0.1));
    const double lag_deg = lag_mm * 1.5 / 300 * 180 / kPi;
    EXPECT_NEAR(path.out().segments.back().duration_s, std::log(lag_deg / 0.001) / 20, 1e-9)
        << "longer than the linear joint";
}

TEST(FollowingError, OnlyExactStopsWait) {
    Path path(loop_setup());
    path.line(300, 0);
    path.standstill();
    EXPECT_EQ(path.out().segments.size(), 1U);
}

}  // namespace
}  // namespace gsim::motion::following_error_test
