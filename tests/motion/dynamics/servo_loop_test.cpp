// The closed form of a servo loop against its differential equation and against closed forms of textbooks.
#include "motion/dynamics/servo_loop.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace gsim::dynamics {
namespace {

/// Loop as defined: a position loop around a lag, by the fourth-order rule of Runge and Kutta.
class Integrated {
  public:
    Integrated(const ServoLoop& loop, const SpeedPolynomial& speed, const ServoError& start)
        : loop_(loop), speed_(speed), error_(start.value), velocity_(speed[0] - start.rate) {}

    void go(double to_s, int steps) {
        const double h = to_s / steps;
        for (int i = 0; i < steps; ++i) step(i * h, h);
    }
    double error() const { return error_; }

  private:
    using State = std::array<double, 2>;  // error, velocity of the joint

    State slope(double t, const State& at) const {
        const auto& [c0, c1, c2, c3] = speed_;
        const double speed = c0 + t * (c1 + t * (c2 + t * c3));
        const double acceleration = c1 + t * (2 * c2 + t * 3 * c3);
        const double command = loop_.gain_1_s * at[0] + loop_.velocity_share * speed +
                               loop_.acceleration_share * loop_.lag_s * acceleration;
        if (loop_.lag_s == 0) return {speed - command, 0};
        return {speed - at[1], (command - at[1]) / loop_.lag_s};
    }
    void step(double t, double h) {
        const State at{error_, velocity_};
        const auto moved = [&](const State& by, double share) {
            return State{at[0] + share * by[0], at[1] + share * by[1]};
        };
        const State a = slope(t, at), b = slope(t + h / 2, moved(a, h / 2));
        const State c = slope(t + h / 2, moved(b, h / 2)), d = slope(t + h, moved(c, h));
        error_ += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0]);
        velocity_ += h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1]);
    }

    ServoLoop loop_;
    SpeedPolynomial speed_;
    double error_;
    double velocity_;
};

TEST(ServoStep, SolvesDifferentialEquation) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int i = 0; i < 2000; ++i) {
        ServoLoop loop{.gain_1_s = std::pow(10, between(0, 2.5)),
                       .velocity_share = between(0, 1),
                       .acceleration_share = between(0, 1),
                       .lag_s = std::pow(10, between(-3, -1))};
        if (i % 4 == 1) loop.lag_s = 0;
        if (i % 4 == 2) loop.lag_s = 1 / (4 * loop.gain_1_s);  // both poles are one
        if (i % 4 == 3) loop.lag_s = (1 + 1e-7 * between(-1, 1)) / (4 * loop.gain_1_s);
        const SpeedPolynomial speed{between(-500, 500), between(-5e3, 5e3), between(-1e4, 1e4),
                                    between(-1e5, 1e5)};
        const ServoError start{between(-5, 5), between(-500, 500)};
        const double t_s = between(0, 0.1);
        Integrated integrated(loop, speed, start);
        integrated.go(t_s, 4000);
        EXPECT_NEAR(ServoStep(loop, speed, start).at(t_s).value, integrated.error(), 1e-8)
            << i << ": gain " << loop.gain_1_s << ", lag " << loop.lag_s;
    }
}

TEST(ServoStep, RateIsDerivativeOfError) {
    const ServoLoop loop{.gain_1_s = 60, .velocity_share = 0.3, .lag_s = 0.02};
    const ServoStep step(loop, {100, 300, -2000, 1e4}, {0.4, -30});
    constexpr double kStep_s = 1e-6;
    for (const double t_s : {0.001, 0.01, 0.1, 0.5}) {
        const double slope = (step.at(t_s + kStep_s).value - step.at(t_s - kStep_s).value) / (2 * kStep_s);
        EXPECT_NEAR(step.at(t_s).rate, slope, 1e-6);
    }
    EXPECT_NEAR(step.at(0).value, 0.4, 1e-12);
    EXPECT_NEAR(step.at(0).rate, -30, 1e-9);
}

// Parts join as if they were one: they add only the rounding of a long path.
TEST(ServoStep, ManyShortStepsEqualOneLongStep) {
    const ServoLoop loop{.gain_1_s = 25, .velocity_share = 0.2, .lag_s = 0.004};
    ServoError error;
    constexpr int kSteps = 10'000;
    for (int i = 0; i < kSteps; ++i) error = ServoStep(loop, {80, 0, 0, 0}, error).at(1e-4);
    EXPECT_NEAR(error.value, ServoStep(loop, {80, 0, 0, 0}, {}).at(1).value, 1e-12);
}

TEST(ServoStep, SteadyErrorMatchesClosedForm) {
    const ServoLoop loop{.gain_1_s = 40, .velocity_share = 0.25, .acceleration_share = 0.5, .lag_s = 0.003};
    EXPECT_NEAR(ServoStep(loop, {200, 0, 0, 0}, {}).at(2).value, 0.75 * 200 / 40, 1e-12);
    // On a ramp the error grows as that of the speed does, less what the lag of the growth is, and what the
    // velocity loop needs for the acceleration.
    const double ramp = 0.75 * 1000 * 2 / 40 - 0.75 * 1000 / (40 * 40) + 0.5 * 0.003 * 1000 / 40;
    EXPECT_NEAR(ServoStep(loop, {0, 1000, 0, 0}, {}).at(2).value, ramp, 1e-12);
}

TEST(ServoStep, FullFeedForwardLeavesNoError) {
    for (const double lag_s : {0.0, 0.005}) {
        const ServoLoop loop{.gain_1_s = 30, .velocity_share = 1, .acceleration_share = 1, .lag_s = lag_s};
        const ServoStep step(loop, {120, 3000, -4e4, 1e5}, {});
        for (const double t_s : {0.0, 0.01, 1.0}) EXPECT_NEAR(step.at(t_s).value, 0, 1e-9);
    }
}

TEST(ServoStep, InfiniteGainLeavesNoError) {
    EXPECT_EQ(ServoStep({}, {120, 3000, 0, 0}, {}).at(0.3).value, 0);
    EXPECT_EQ(ServoLoop{}.constant_speed_lag_s(), 0);
}

TEST(ServoLoop, ReturnsSlowestDecayRate) {
    EXPECT_EQ((ServoLoop{.gain_1_s = 30}).slowest_1_s(), 30);
    EXPECT_NEAR((ServoLoop{.gain_1_s = 100, .lag_s = 0.01}).slowest_1_s(), 50, 1e-12);  // it swings
    // s^2 lag + s + gain has the roots -100 and -400 here.
    EXPECT_NEAR((ServoLoop{.gain_1_s = 80, .lag_s = 0.002}).slowest_1_s(), 100, 1e-9);
}

// A step of a damped loop never leaves the bound that long steps rely on.
TEST(ServoStep, TransientStaysWithinBound) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const ServoLoop loop{.gain_1_s = std::pow(10, 1.5 + any(random)),
                             .lag_s = i % 3 == 0 ? 0 : std::pow(10, -2 + any(random))};
        const ServoStep step(loop, {0, 0, 0, 0}, {any(random), 100 * any(random)});
        const double bound = step.transient_bound() * (1 + 1e-9);
        for (const double t_s : {0.0, 0.001, 0.01, 0.05, 0.2}) EXPECT_LE(std::abs(step.at(t_s).value), bound);
    }
}

}  // namespace
}  // namespace gsim::dynamics
