#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/linuxcnc/profile.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::linuxcnc::linuxcnc_profile_test {
namespace {

constexpr Clock kMillisecond{1e-3, true};
constexpr Clock kContinuous{1e-3, false};

Stretch random_stretch(std::mt19937& random) {
    std::uniform_real_distribution<double> decade(-1.5, 1.5);
    return {20 * std::pow(10, decade(random)), 60 * std::pow(10, decade(random)),
            500 * std::pow(10, decade(random) / 2)};
}

// Returns the time period by period, as fast as the limits and the remaining path allow. One more period at
// the new speed v and then braking takes (v_old + v) dt / 2 + v^2 / 2a.
double stepped_s(const Stretch& section, double dt) {
    const double step = section.acceleration * dt;
    double speed = 0, remaining = section.length, time_s = 0;
    while (remaining > 1e-11 * section.length) {
        const double half = step / 2;
        const double square = half * half + 2 * section.acceleration * remaining - step * speed;
        const double brake = square > 0 ? std::sqrt(square) - half : 0;
        const double next = std::max(0.0, std::min({speed + step, section.top_speed, brake}));
        remaining -= (speed + next) * dt / 2;
        speed = next;
        time_s += dt;
    }
    return time_s;
}

TEST(LinuxcncProfile, MatchesPeriodsOfSteppedController) {
    std::mt19937 random(11);
    int off = 0;
    for (int i = 0; i < 500; ++i) {
        const Stretch section = random_stretch(random);
        const double counted_s = rest_to_rest(section, kMillisecond).law.duration_s();
        const double expected_s = stepped_s(section, 1e-3);
        ASSERT_NEAR(counted_s, expected_s, 1.001e-3) << "case " << i;
        if (std::abs(counted_s - expected_s) > 1e-6) ++off;
    }
    EXPECT_LE(off, 5);  // the stepped one may lose a period to rounding
}

TEST(LinuxcncProfile, ExceedsTrapezoidByLessThanThreePeriods) {
    std::mt19937 random(12);
    for (int i = 0; i < 2000; ++i) {
        const Stretch section = random_stretch(random);
        const double min_s = trapezoid_s(section.length, section.top_speed, section.acceleration);
        const Law counted = rest_to_rest(section, kMillisecond).law;
        ASSERT_GE(counted.duration_s(), min_s - 1e-9);
        ASSERT_LT(counted.duration_s(), min_s + 3e-3) << "case " << i;
        const double periods = counted.duration_s() / 1e-3;
        ASSERT_NEAR(periods, std::round(periods), 1e-6);
        ASSERT_NEAR(rest_to_rest(section, kContinuous).law.duration_s(), min_s, 1e-9 * min_s);
    }
}

TEST(LinuxcncProfile, KeepsLimitsAndStopsAtTarget) {
    std::mt19937 random(13);
    for (int i = 0; i < 500; ++i) {
        const Stretch section = random_stretch(random);
        const TimeLaw law = rest_to_rest(section, kMillisecond).law.scaled(1);
        ASSERT_NEAR(law.length(), section.length, 1e-9 * section.length) << "case " << i;
        ASSERT_NEAR(law.end_speed(), 0, 1e-6 * section.top_speed);
        ASSERT_LE(law.peak_speed(), section.top_speed * (1 + 1e-6));
        ASSERT_LE(law.peak_acceleration(), section.acceleration * (1 + 1e-6));
        double speed = 0;
        for (const LawSection& sub_segment : law.sections()) {
            ASSERT_NEAR(sub_segment.v0, speed, 1e-6 * section.top_speed) << "case " << i;
            speed = sub_segment.v0 + sub_segment.a0 * sub_segment.duration_s;
        }
    }
}

TEST(LinuxcncProfile, VeryLowSpeedTakesCruiseTimeOnly) {
    // 0.1 mm/s at 490 mm/s2: the ramps take no visible time.
    const Law law = rest_to_rest({1, 0.1, 490.3}, kMillisecond).law;
    EXPECT_NEAR(law.duration_s(), 10, 2e-3);
    EXPECT_NEAR(law.length(), 1, 1e-9);
}

TEST(LinuxcncProfile, RampsBetweenSpeedsMatchClosedForm) {
    const Profile up = from_speed_to_speed({100, 1000, 200}, 50, 400);  // not reached
    EXPECT_NEAR(up.end_speed, std::sqrt(50 * 50 + 2 * 200 * 100), 1e-9);
    EXPECT_NEAR(up.law.duration_s(), (up.end_speed - 50) / 200, 1e-9);
    const Profile down = from_speed_to_speed({10, 1000, 200}, 100, 20);  // too short to brake
    EXPECT_NEAR(down.end_speed, std::sqrt(100 * 100 - 2 * 200 * 10), 1e-9);
    const Profile slower = from_speed_to_speed({100, 40, 200}, 60, 10);  // brakes to its own speed first
    const double cruise_mm = 100 - (60 * 60 - 10 * 10) / (2 * 200.0);
    EXPECT_NEAR(slower.law.duration_s(), 50 / 200.0 + cruise_mm / 40, 1e-9);
    const Profile stop = from_speed_to_speed({1, 1000, 200}, 100, 0);  // must stop, whatever it takes
    EXPECT_EQ(stop.end_speed, 0);
    EXPECT_NEAR(stop.law.length(), 1, 1e-12);
}

TEST(LinuxcncProfile, PartsOfLawJoin) {
    std::mt19937 random(14);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 500; ++i) {
        const Law law = rest_to_rest(random_stretch(random), kMillisecond).law;
        const double at_s = share(random) * law.duration_s();
        const Law begin = law.part(0, at_s), remainder = law.part(at_s, law.duration_s());
        ASSERT_NEAR(begin.length(), law.at(at_s), 1e-9 * law.length());
        ASSERT_NEAR(begin.length() + remainder.length(), law.length(), 1e-9 * law.length());
        ASSERT_NEAR(begin.duration_s() + remainder.duration_s(), law.duration_s(), 1e-12);
        const double length = share(random) * law.length();
        ASSERT_NEAR(law.at(law.time_at(length)), length, 1e-9 * law.length());
    }
}

}  // namespace
}  // namespace gsim::motion::linuxcnc::linuxcnc_profile_test
