// Ramps in steps of time, against times of grblHAL and what holds of any ramps.
#include "motion/profile/stepped_ramps.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::motion::stepped_ramps_test {
namespace {

constexpr double kStep_s = 0.01;

/// Block in mm and s, from standstill to standstill by default.
struct Asked {
    double length_mm = 50;
    double speed_mm_s = 100;
    double acceleration_mm_s2 = 1000;
    double jerk_mm_s3 = 10'000;
    double entry_mm_s = 0;
    double exit_mm_s = 0;
};

SteppedBlock make_block(const Asked& requested) {
    const auto per_minute = [](double value, int power) {
        return static_cast<float>(value * std::pow(60, power));
    };
    const float acceleration = per_minute(requested.acceleration_mm_s2, 2);
    const float jerk = per_minute(requested.jerk_mm_s3, 3);
    const float speed = per_minute(requested.speed_mm_s, 1);
    return {static_cast<float>(requested.length_mm),
            per_minute(requested.entry_mm_s, 1),
            per_minute(requested.exit_mm_s, 1),
            speed,
            SteppedRamps::mean_acceleration(speed, acceleration, jerk),
            acceleration,
            jerk};
}

struct ExecutedBlock {
    double time_s = 0;
    double length_mm = 0;
    double crawled_s = 0;
    std::vector<LawSection> sections;
};

ExecutedBlock drive(const SteppedBlock& block, SteppedRamps& ramps) {
    ExecutedBlock driven;
    ramps.drive(block, [&](const SteppedSection& section) {
        const LawSection& law = section.law;
        driven.time_s += law.duration_s;
        driven.length_mm += law.v0 * law.duration_s + law.a0 * law.duration_s * law.duration_s / 2;
        if (section.stops_short) driven.crawled_s += law.duration_s;
        driven.sections.push_back(law);
    });
    return driven;
}

ExecutedBlock drive(const Asked& requested) {
    SteppedRamps ramps(kStep_s);
    return drive(make_block(requested), ramps);
}

TEST(SteppedRamps, MeanAccelerationEqualsSCurveFromStandstill) {
    // Standstill to v takes v/a + a/J if that reaches a, else 2 sqrt(v/J).
    EXPECT_NEAR(SteppedRamps::mean_acceleration_s(100, 1000, 10'000), 100 / (0.1 + 0.1), 1e-3);
    EXPECT_NEAR(SteppedRamps::mean_acceleration_s(500, 1000, 10'000), 500 / (0.5 + 0.1), 1e-3);
    EXPECT_NEAR(SteppedRamps::mean_acceleration_s(50, 1000, 10'000), 50 / (2 * std::sqrt(50 / 10'000.0)),
                1e-3);
}

// Lines from standstill to standstill as grblHAL was measured, most of them crawling at their end.
TEST(SteppedRamps, TakeMeasuredTimesOfGrblHal) {
    EXPECT_NEAR(drive({.length_mm = 50}).time_s, 7.069, 0.002);
    EXPECT_NEAR(drive({.length_mm = 10}).time_s, 0.2493, 0.0002);
    EXPECT_NEAR(drive({.length_mm = 50, .jerk_mm_s3 = 2000}).time_s, 49.51, 0.02);
    EXPECT_NEAR(drive({.length_mm = 50, .jerk_mm_s3 = 100'000}).time_s, 0.6650, 0.0002);
    EXPECT_NEAR(drive({.length_mm = 50, .speed_mm_s = 25}).time_s, 2.1877, 0.0002);
}

TEST(SteppedRamps, ReportCrawlTime) {
    const ExecutedBlock creeps = drive({.length_mm = 50});
    EXPECT_GT(creeps.crawled_s, 5.5);
    EXPECT_LT(creeps.crawled_s, 6.5);
    EXPECT_EQ(drive({.length_mm = 10}).crawled_s, 0);
}

// With steps that are short compared with the ramps, and without a jerk limit, they are trapezoids.
TEST(SteppedRamps, BecomeTrapezoidsWithFineStepsAndHighJerk) {
    SteppedRamps ramps(1e-4);
    const ExecutedBlock driven = drive(make_block({.length_mm = 50, .jerk_mm_s3 = 1e9}), ramps);
    EXPECT_NEAR(driven.time_s, 0.5 + 0.1, 1e-2);  // it crawls for 6 ms
}

TEST(SteppedRamps, CoverLengthWithoutMovingBack) {
    std::mt19937 random(3);
    const auto number = [&](double from, double to) {
        return std::exp(std::uniform_real_distribution<double>(std::log(from), std::log(to))(random));
    };
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE(i);
        Asked requested{number(0.01, 500), number(1, 300), number(50, 5000), number(500, 200'000)};
        SteppedBlock block = make_block(requested);
        // The planner's limit: the speed that it can brake from and to with the mean acceleration.
        const auto max = [&] {
            return std::min(block.speed_mm_min,
                            std::sqrt(2 * block.mean_acceleration_mm_min2 * block.length_mm) * 0.5F);
        };
        block.entry_mm_min = max() * std::uniform_real_distribution<float>(0, 1)(random);
        block.exit_mm_min = max() * std::uniform_real_distribution<float>(0, 1)(random);
        SteppedRamps ramps(kStep_s);
        const ExecutedBlock driven = drive(block, ramps);
        ASSERT_NEAR(driven.length_mm, requested.length_mm, 1e-5 * requested.length_mm);
        for (const LawSection& section : driven.sections) {
            ASSERT_GT(section.duration_s, 0);
            ASSERT_GE(section.v0, 0);
            ASSERT_GE(section.v0 + section.a0 * section.duration_s, -1e-6 * (1 + section.v0));
        }
    }
}

// Lengths for which a step of time is lost with 32 bits, unrealistic speeds, and blocks entered too fast.
TEST(SteppedRamps, TerminateForExtremeValues) {
    for (const double length_mm : {1e-6, 1.0, 1e6}) {
        for (const double speed_mm_s : {1e-3, 1.0, 1e4}) {
            for (const double jerk_mm_s3 : {1.0, 1e9}) {
                const ExecutedBlock driven =
                    drive({.length_mm = length_mm, .speed_mm_s = speed_mm_s, .jerk_mm_s3 = jerk_mm_s3});
                EXPECT_TRUE(std::isfinite(driven.time_s));
                EXPECT_NEAR(driven.length_mm, length_mm, 1e-3 * length_mm);
            }
        }
    }
    const ExecutedBlock slowed = drive({.length_mm = 50, .speed_mm_s = 20, .entry_mm_s = 100});
    EXPECT_NEAR(slowed.length_mm, 50, 1e-3);
}

}  // namespace
}  // namespace gsim::motion::stepped_ramps_test
