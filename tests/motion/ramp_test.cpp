#include "motion/profile/ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace gsim::motion::ramp_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
    double from, to, length, acceleration, jerk;
};

testing::Message what(const Case& c) {
    return testing::Message() << "from " << c.from << " to " << c.to << " length " << c.length
                              << " acceleration " << c.acceleration << " jerk " << c.jerk;
}

class Cases {
  public:
    explicit Cases(unsigned seed) : random_(seed) {}

    Case next() {
        Case c{log_uniform(1e-3, 1e4), log_uniform(1e-3, 1e4), log_uniform(1e-9, 1e6), log_uniform(1, 1e6),
               log_uniform(1, 1e9)};
        if (chance(0.1)) c.from = 0;
        if (chance(0.1)) c.acceleration = kInfinity;
        if (chance(0.1)) c.jerk = kInfinity;
        if (std::isinf(c.acceleration) && std::isinf(c.jerk)) c.acceleration = 1000;
        return c;
    }

    double log_uniform(double low, double high) {
        return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random_));
    }
    bool chance(double share) { return std::bernoulli_distribution(share)(random_); }

  private:
    std::mt19937 random_;
};

// Returns the length of a ramp up in fine steps, from only its acceleration over time: a trapezoid.
double integrated_length(double from, const RampPhases& ramp) {
    constexpr int kSteps = 200;
    double v = from;
    double s = 0;
    const auto phase = [&](double duration_s, double first, double last) {
        const double dt = duration_s / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const double next_v = v + dt * (first + (last - first) * (i + 0.5) / kSteps);
            s += dt * (v + next_v) / 2;
            v = next_v;
        }
    };
    phase(ramp.jerk_s, 0, ramp.acceleration);
    phase(ramp.constant_s, ramp.acceleration, ramp.acceleration);
    phase(ramp.jerk_s, ramp.acceleration, 0);
    return s;
}

TEST(Ramp, HasConstantAccelerationWithoutJerkLimit) {
    EXPECT_DOUBLE_EQ(ramp_s(10, 30, 10, kInfinity), 2);
    EXPECT_DOUBLE_EQ(ramp_length(10, 30, 10, kInfinity), 40);
    EXPECT_DOUBLE_EQ(ramp_length(30, 10, 10, kInfinity), 40);
    EXPECT_DOUBLE_EQ(ramp_end_speed(40, 10, 10, kInfinity), 30);
    EXPECT_DOUBLE_EQ(reachable_speed(40, 10, 10, kInfinity), 30);
}

TEST(Ramp, ShortRampDoesNotReachAccelerationLimit) {
    // 1 s at +8 mm/s3 and 1 s at -8: 8 mm/s faster, at most 8 mm/s2.
    EXPECT_DOUBLE_EQ(ramp_s(2, 10, 1000, 8), 2);
    EXPECT_DOUBLE_EQ(ramp_length(2, 10, 1000, 8), 12);
    EXPECT_DOUBLE_EQ(ramp_phases(8, 1000, 8).acceleration, 8);
    EXPECT_DOUBLE_EQ(ramp_end_speed(12, 2, 1000, 8), 10);
}

TEST(Ramp, LongRampHoldsAccelerationLimit) {
    // 1 s up to 8 mm/s2, 2 s at 8 mm/s2, 1 s down: 24 mm/s faster in 4 s.
    const RampPhases ramp = ramp_phases(24, 8, 8);
    EXPECT_DOUBLE_EQ(ramp.jerk_s, 1);
    EXPECT_DOUBLE_EQ(ramp.constant_s, 2);
    EXPECT_DOUBLE_EQ(ramp_length(24, 0, 8, 8), 48);
    EXPECT_DOUBLE_EQ(ramp_end_speed(48, 0, 8, 8), 24);
}

TEST(Ramp, IgnoresInfiniteLimits) {
    EXPECT_EQ(ramp_s(1, 9, kInfinity, kInfinity), 0);
    EXPECT_EQ(ramp_length(1, 9, kInfinity, kInfinity), 0);
    EXPECT_EQ(ramp_end_speed(1, 9, kInfinity, kInfinity), kInfinity);
    EXPECT_EQ(reachable_speed(1, 9, kInfinity, kInfinity), kInfinity);
    EXPECT_DOUBLE_EQ(ramp_s(2, 10, kInfinity, 8), 2);
    EXPECT_DOUBLE_EQ(ramp_end_speed(12, 2, kInfinity, 8), 10);
}

TEST(Ramp, ZeroLengthKeepsSpeed) {
    EXPECT_EQ(ramp_s(7, 7, 10, 10), 0);
    EXPECT_EQ(ramp_length(7, 7, 10, 10), 0);
    for (const double jerk : {10.0, kInfinity}) {
        EXPECT_EQ(ramp_end_speed(0, 7, 10, jerk), 7);
        EXPECT_EQ(reachable_speed(0, 7, 10, jerk), 7);
        EXPECT_EQ(reachable_speed(0, 0, 10, jerk), 0);
    }
}

TEST(Ramp, PhasesKeepLimitsAndSumToChangeAndLength) {
    Cases cases(31);
    for (int i = 0; i < 2000; ++i) {
        const Case c = cases.next();
        const double change = std::abs(c.to - c.from);
        const RampPhases ramp = ramp_phases(change, c.acceleration, c.jerk);
        ASSERT_GE(ramp.constant_s, 0) << what(c);
        ASSERT_LE(ramp.acceleration, c.acceleration * (1 + 1e-12)) << what(c);
        if (std::isfinite(c.jerk)) {
            ASSERT_NEAR(ramp.acceleration, c.jerk * ramp.jerk_s, 1e-12 * ramp.acceleration) << what(c);
        }
        ASSERT_NEAR(ramp.acceleration * (ramp.jerk_s + ramp.constant_s), change, 1e-12 * change) << what(c);
        const double length = ramp_length(c.from, c.to, c.acceleration, c.jerk);
        ASSERT_NEAR(integrated_length(std::min(c.from, c.to), ramp), length, 1e-5 * length) << what(c);
    }
}

TEST(Ramp, EndSpeedIsInverseOfLength) {
    Cases cases(32);
    for (int i = 0; i < 100'000; ++i) {
        Case c = cases.next();
        if (c.to < c.from) std::swap(c.to, c.from);
        const double length = ramp_length(c.from, c.to, c.acceleration, c.jerk);
        const double end = ramp_end_speed(length, c.from, c.acceleration, c.jerk);
        ASSERT_NEAR(end, c.to, 1e-13 * c.to) << what(c);
        const double gain = ramp_gain(c.length, c.from, c.acceleration, c.jerk);
        ASSERT_NEAR(ramp_length_by(c.from, gain, c.acceleration, c.jerk), c.length, 1e-13 * c.length)
            << what(c);
    }
}

TEST(Ramp, RampToReachableSpeedFitsLengthDespiteRounding) {
    Cases cases(33);
    for (int i = 0; i < 100'000; ++i) {
        const Case c = cases.next();
        for (const double end : {ramp_end_speed(c.length, c.from, c.acceleration, c.jerk),
                                 reachable_speed(c.length, c.from, c.acceleration, c.jerk)}) {
            ASSERT_GE(end, c.from) << what(c);
            ASSERT_LE(ramp_length(c.from, end, c.acceleration, c.jerk), c.length * (1 + 1e-12)) << what(c);
        }
    }
}

TEST(Ramp, ReachableSpeedIsMonotoneInLengthAndStart) {
    Cases cases(34);
    for (int i = 0; i < 100'000; ++i) {
        const Case c = cases.next();
        const double reached = reachable_speed(c.length, c.from, c.acceleration, c.jerk);
        const double tolerance = 1e-14 * reached;
        const double more = 1 + cases.log_uniform(1e-12, 10);
        ASSERT_GE(reachable_speed(c.length * more, c.from, c.acceleration, c.jerk), reached - tolerance)
            << what(c);
        ASSERT_GE(reachable_speed(c.length, c.from * more, c.acceleration, c.jerk), reached - tolerance)
            << what(c);
        const double other_start = cases.log_uniform(1e-4, 1) * reached;
        const double other = reachable_speed(c.length, other_start, c.acceleration, c.jerk);
        ASSERT_GE((other - reached) * (other_start - c.from), -tolerance * reached) << what(c);
    }
}

// The trap that reachable_speed() is there for.
TEST(Ramp, EndSpeedMayFallAsStartSpeedRises) {
    EXPECT_LT(ramp_end_speed(1, 0.2, kInfinity, 1), ramp_end_speed(1, 0, kInfinity, 1));
    EXPECT_GE(reachable_speed(1, 0.2, kInfinity, 1), reachable_speed(1, 0, kInfinity, 1));
    // A start that is planned from standstill and then raised: the ramp would not fit any more.
    EXPECT_GT(ramp_length(ramp_end_speed(1, 0, kInfinity, 1), 0.2, kInfinity, 1), 1);
    EXPECT_LE(ramp_length(reachable_speed(1, 0, kInfinity, 1), 0.2, kInfinity, 1), 1);
}

TEST(Ramp, ReachableSpeedIsMinEndSpeedOfHigherStarts) {
    Cases cases(35);
    for (int i = 0; i < 1000; ++i) {
        const Case c = cases.next();
        const double exact = ramp_end_speed(c.length, c.from, c.acceleration, c.jerk);
        double min = exact;
        constexpr int kStarts = 300;
        for (int k = 1; k <= kStarts; ++k) {
            const double start = c.from + (exact - c.from) * k / kStarts;
            min = std::min(min, ramp_end_speed(c.length, start, c.acceleration, c.jerk));
        }
        const double reached = reachable_speed(c.length, c.from, c.acceleration, c.jerk);
        ASSERT_LE(reached, min * (1 + 1e-13)) << what(c);
        ASSERT_NEAR(reached, min, 1e-4 * min) << what(c);
        ASSERT_GE(reached, exact * (1 - 0.056)) << what(c);
        if (c.from >= c.acceleration * c.acceleration / (2 * c.jerk)) {
            ASSERT_EQ(reached, exact) << what(c);
        }
    }
}

TEST(Ramp, OddValuesNeitherHangNorCrash) {
    const double odd[] = {0, -1, 1, 1e-300, 1e300, kInfinity, std::numeric_limits<double>::quiet_NaN()};
    for (const double length : odd) {
        for (const double speed : odd) {
            for (const double acceleration : odd) {
                for (const double jerk : odd) {
                    ramp_length(speed, length, acceleration, jerk);
                    reachable_speed(length, speed, acceleration, jerk);
                }
            }
        }
    }
}

}  // namespace
}  // namespace gsim::motion::ramp_test
