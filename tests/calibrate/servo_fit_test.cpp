// Servo loops that are hidden in recordings, found again.

#include "calibrate/servo/servo_fit.h"

#include <cmath>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::calibrate::servo_fit_test {
namespace {

constexpr double kPeriod_s = 0.001;

/// Returns strokes there and back over several distances, with straight ramps, and dwells.
AxisRecord strokes() {
    AxisRecord record;
    double at = 0;
    const auto append = [&](double value) {
        record.t_s.push_back(kPeriod_s * static_cast<double>(record.t_s.size()));
        record.set_points.push_back(value);
    };
    for (const double distance : {20.0, -5.0, 1.0, -16.0}) {
        constexpr double kAcceleration = 800;
        const double ramp_s = std::sqrt(std::abs(distance) / kAcceleration);
        const double sense = std::copysign(1.0, distance);
        for (double t = 0; t < 2 * ramp_s; t += kPeriod_s) {
            const double remaining_s = 2 * ramp_s - t;
            append(at + sense * (t < ramp_s
                                     ? kAcceleration / 2 * t * t
                                     : std::abs(distance) - kAcceleration / 2 * remaining_s * remaining_s));
        }
        at += distance;
        for (int i = 0; i < 200; ++i) append(at);
    }
    return record;
}

/// An encoder of 0.1 um steps on a machine that trembles by as much.
AxisRecord recorded(const machine::Servo& servo, unsigned seed, double noise = 1e-4) {
    AxisRecord record = strokes();
    record.positions.assign(record.set_points.size(), record.set_points.front());
    record.positions = simulate_following(servo, record);
    std::mt19937 random(seed);
    std::normal_distribution<double> off(0, noise);
    for (double& place : record.positions) place += off(random);
    return record;
}

double value_of(const ServoFit& fit, const std::string& key) {
    for (const FittedServoParameter& parameter : fit.fitted_parameters) {
        if (parameter.key == key) return parameter.value;
    }
    return 0;
}

TEST(ServoFit, FindsGainWithoutOtherParameters) {
    const machine::Servo ground_truth{.position_gain_1_s = 40};
    const ServoFit fit = fit_servo(recorded(ground_truth, 1)).value();
    ASSERT_EQ(fit.fitted_parameters.size(), 1U) << "no figure that is not there";
    EXPECT_NEAR(fit.servo.position_gain_1_s, 40, 0.02);
    EXPECT_NEAR(fit.residual_rms, 1e-4, 1e-5);
}

/// The test integrates the equations in fine steps, which the fit does not.
TEST(ServoFit, SimulationMatchesEquationsOfLoop) {
    const machine::Servo servo{
        .position_gain_1_s = 35, .velocity_feed_forward = 0.6, .velocity_lag_s = 0.004};
    AxisRecord record = strokes();
    record.positions.assign(record.set_points.size(), 0);
    const auto positions = simulate_following(servo, record);
    double x = 0, v = 0;
    for (std::size_t i = 1; i < record.t_s.size(); ++i) {
        const double speed = (record.set_points[i] - record.set_points[i - 1]) / kPeriod_s;
        constexpr int kParts = 200;
        for (int part = 0; part < kParts; ++part) {
            const double h = kPeriod_s / kParts;
            const double set_point = record.set_points[i - 1] + speed * h * (part + 0.5);
            const double command = 35 * (set_point - x) + 0.6 * speed;
            v += h * (command - v) / 0.004;
            x += h * v;
        }
        ASSERT_NEAR(positions[i], x, 5e-4) << i;
    }
}

TEST(ServoFit, FindsAllParametersWithinTheirSpread) {
    const machine::Servo ground_truth{.position_gain_1_s = 33,
                                      .velocity_feed_forward = 0.7,
                                      .acceleration_feed_forward = 0.4,
                                      .velocity_lag_s = 0.005,
                                      .command_delay_s = 0.002};
    int inside = 0, all = 0;
    for (unsigned seed = 0; seed < 10; ++seed) {
        const ServoFit fit = fit_servo(recorded(ground_truth, seed)).value();
        ASSERT_EQ(fit.fitted_parameters.size(), 5U);
        EXPECT_NEAR(fit.residual_rms, 1e-4, 1e-5);
        for (const auto& [key, truth] :
             {std::pair{"position_gain_1_s", 33.0}, std::pair{"velocity_feed_forward", 0.7},
              std::pair{"acceleration_feed_forward", 0.4}, std::pair{"velocity_lag_s", 0.005},
              std::pair{"command_delay_s", 0.002}}) {
            for (const FittedServoParameter& parameter : fit.fitted_parameters) {
                if (parameter.key != std::string(key)) continue;
                ++all;
                if (std::abs(parameter.value - truth) < 3 * parameter.standard_deviation) ++inside;
            }
            EXPECT_NEAR(value_of(fit, key), truth, 0.1 * truth) << key;
        }
    }
    EXPECT_GE(inside, all - 2);
}

TEST(ServoFit, RejectsRecordsWithoutInformation) {
    AxisRecord still = strokes();
    still.set_points.assign(still.set_points.size(), 3);
    still.positions = still.set_points;
    EXPECT_THAT(fit_servo(still).error().message, testing::HasSubstr("does not move"));
    AxisRecord perfect = strokes();
    perfect.positions = perfect.set_points;
    EXPECT_THAT(fit_servo(perfect).error().message,
                testing::HasSubstr("no following error that can be fitted"));
}

}  // namespace
}  // namespace gsim::calibrate::servo_fit_test
