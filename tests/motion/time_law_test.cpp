#include "motion/profile/time_law.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/motion/segment_checks.h"

namespace gsim::motion::time_law_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Distance from the law's speeds alone, by Simpson's rule over fine steps.
double integrated(const TimeLaw& law, double until_s) {
    constexpr int kSteps = 2000;
    const double dt = until_s / kSteps;
    double s = 0;
    for (int i = 0; i < kSteps; ++i) {
        s += dt / 6 * (law.at(i * dt).v + 4 * law.at((i + 0.5) * dt).v + law.at((i + 1) * dt).v);
    }
    return s;
}

TEST(TimeLaw, ZeroLengthTakesNoTime) {
    const TimeLaw law{};
    EXPECT_EQ(law.duration_s(), 0);
    EXPECT_EQ(law.at(0).s, 0);
    EXPECT_EQ(TimeLaw::fastest(0, 10, 10).duration_s(), 0);
    EXPECT_EQ(TimeLaw::fastest(0, 10, 10).at(1).v, 0);
}

TEST(TimeLaw, TrapezoidMatchesHandCalculation) {
    // 1 s up and 1 s down at 100 mm/s2 are 100 mm; 200 mm remain for 2 s at 100 mm/s.
    const TimeLaw law = TimeLaw::fastest(300, 100, 100);
    EXPECT_DOUBLE_EQ(law.duration_s(), 4);
    EXPECT_DOUBLE_EQ(law.peak_speed(), 100);
    EXPECT_DOUBLE_EQ(law.at(0.5).s, 12.5);
    EXPECT_DOUBLE_EQ(law.at(0.5).v, 50);
    EXPECT_DOUBLE_EQ(law.at(0.5).a, 100);
    EXPECT_DOUBLE_EQ(law.at(2).s, 150);
    EXPECT_DOUBLE_EQ(law.at(2).a, 0);
    EXPECT_DOUBLE_EQ(law.at(3.5).s, 287.5);
    EXPECT_DOUBLE_EQ(law.at(3.5).a, -100);
}

TEST(TimeLaw, TriangleMatchesHandCalculation) {
    const TimeLaw law = TimeLaw::fastest(100, 1000, 100);
    EXPECT_DOUBLE_EQ(law.duration_s(), 2);
    EXPECT_DOUBLE_EQ(law.peak_speed(), 100);
    EXPECT_DOUBLE_EQ(law.at(1).s, 50);
}

TEST(TimeLaw, IgnoresInfiniteLimits) {
    EXPECT_DOUBLE_EQ(TimeLaw::fastest(100, 50, kInfinity).duration_s(), 2);
    EXPECT_DOUBLE_EQ(TimeLaw::fastest(100, 50, kInfinity).at(1).s, 50);
    EXPECT_DOUBLE_EQ(TimeLaw::fastest(100, 50, kInfinity).at(0).v, 50);
    EXPECT_DOUBLE_EQ(TimeLaw::fastest(100, kInfinity, 100).duration_s(), 2);
    EXPECT_EQ(TimeLaw::fastest(100, kInfinity, kInfinity).duration_s(), 0);
    EXPECT_EQ(TimeLaw::fastest(100, kInfinity, kInfinity).at(0).s, 100);
}

TEST(TimeLaw, ClampsTimeToDurationAndEndsExactly) {
    const TimeLaw law = TimeLaw::fastest(0.1 + 0.2, 0.7, 0.3);
    EXPECT_EQ(law.at(-1).s, 0);
    EXPECT_EQ(law.at(law.duration_s()).s, 0.1 + 0.2);
    EXPECT_EQ(law.at(1e9).s, 0.1 + 0.2);
    EXPECT_NEAR(law.at(1e9).v, 0, 1e-12);
}

TEST(TimeLaw, WithDurationMatchesHandCalculation) {
    // 300 mm in 4 s with ramps of 100 mm/s2 is the trapezoid above; with more time it only cruises slower.
    EXPECT_DOUBLE_EQ(TimeLaw::with_duration(300, 4, 100).peak_speed(), 100);
    const TimeLaw slow = TimeLaw::with_duration(300, 7, 100);
    EXPECT_DOUBLE_EQ(slow.at(0.1).a, 100);
    EXPECT_DOUBLE_EQ(slow.peak_speed() * (7 - slow.peak_speed() / 100), 300);
    EXPECT_DOUBLE_EQ(TimeLaw::with_duration(300, 4, kInfinity).peak_speed(), 75);
}

TEST(TimeLaw, WithDurationAcceptsShortfallWithinRounding) {
    const double min = TimeLaw::fastest_s(7, kInfinity, 3);
    const TimeLaw law = TimeLaw::with_duration(7, min * (1 - 1e-15), 3);
    EXPECT_EQ(law.at(min).s, 7);
    EXPECT_LE(law.at(0).a, 3 * (1 + kRelative));
}

TEST(TimeLaw, StandstillMayTakeTime) {
    const TimeLaw law = TimeLaw::with_duration(0, 5, 100);
    EXPECT_EQ(law.duration_s(), 5);
    EXPECT_EQ(law.at(3).s, 0);
    EXPECT_EQ(law.at(3).v, 0);
}

TEST(TimeLaw, FastestLawBeginsAndEndsAtStandstill) {
    const TimeLaw law = TimeLaw::fastest(300, 100, 100);
    EXPECT_EQ(law.start_speed(), 0);
    EXPECT_EQ(law.end_speed(), 0);
    EXPECT_DOUBLE_EQ(law.peak_acceleration(), 100);
    EXPECT_EQ(TimeLaw{}.peak_acceleration(), 0);
}

TEST(TimeLaw, TrapezoidBetweenSpeedsMatchesHandCalculation) {
    // 1 s from 50 to 100 at 50 mm/s2, 1 s at 100, 1 s down to 20 at 80 mm/s2: 75 + 100 + 60 mm.
    const TimeLaw law = TimeLaw::between(235, 50, 20, {100, 50, 80, kInfinity});
    EXPECT_EQ(law.sections().size(), 3U);
    EXPECT_DOUBLE_EQ(law.duration_s(), 3);
    EXPECT_DOUBLE_EQ(law.at(1).s, 75);
    EXPECT_DOUBLE_EQ(law.at(0.5).a, 50);
    EXPECT_DOUBLE_EQ(law.at(2.5).a, -80);
    EXPECT_DOUBLE_EQ(law.at(3).v, 20);
    EXPECT_DOUBLE_EQ(law.peak_acceleration(), 80);
}

TEST(TimeLaw, BrakesFirstIfStartIsTooFast) {
    // 1 s down to 60 at 40 mm/s2, 1 s at 60, 1 s down to 20: 80 + 60 + 40 mm.
    const TimeLaw law = TimeLaw::between(180, 100, 20, {60, 1000, 40, kInfinity});
    EXPECT_DOUBLE_EQ(law.duration_s(), 3);
    EXPECT_DOUBLE_EQ(law.at(1).v, 60);
    EXPECT_DOUBLE_EQ(law.at(2).v, 60);
    EXPECT_DOUBLE_EQ(law.peak_speed(), 100);
}

TEST(TimeLaw, FromSectionsHasValuesOfSections) {
    // Up by jerk and past the peak at 2 s, then constant speed; the part without duration is omitted.
    const LawSection sections[] = {{3, 0, 1, 4, -2}, {0, 12, 4, 0, 0}, {2, 12, 4, 0, 0}};
    const TimeLaw law = TimeLaw::from_sections(sections);
    EXPECT_EQ(law.sections().size(), 2U);
    EXPECT_DOUBLE_EQ(law.duration_s(), 5);
    EXPECT_DOUBLE_EQ(law.length(), 20);
    EXPECT_DOUBLE_EQ(law.start_speed(), 1);
    EXPECT_DOUBLE_EQ(law.end_speed(), 4);
    EXPECT_DOUBLE_EQ(law.peak_speed(), 5);
    EXPECT_DOUBLE_EQ(law.peak_acceleration(), 4);
    EXPECT_DOUBLE_EQ(law.at(2).v, 5);
    EXPECT_DOUBLE_EQ(law.at(4).s, 16);
    EXPECT_EQ(TimeLaw::from_sections({}).duration_s(), 0);
}

TEST(TimeLaw, FromSectionsCopiesLaw) {
    const TimeLaw law = TimeLaw::between(70, 3, 5, {20, 15, 10, 40});
    const TimeLaw copy = TimeLaw::from_sections(law.sections());
    EXPECT_DOUBLE_EQ(copy.length(), 70);
    EXPECT_DOUBLE_EQ(copy.duration_s(), law.duration_s());
    EXPECT_DOUBLE_EQ(copy.peak_speed(), law.peak_speed());
    EXPECT_NEAR(copy.end_speed(), 5, 1e-12);
}

struct Case {
    double length, speed, acceleration, section;
};

Case random_case(std::mt19937& random) {
    std::uniform_real_distribution<double> log_scale(-9, 9);
    std::bernoulli_distribution coin(0.3);
    Case c{std::exp(log_scale(random)), std::exp(log_scale(random)), std::exp(log_scale(random)), 0};
    if (coin(random)) c.length = c.speed * c.speed / c.acceleration;  // the edge of triangle and trapezoid
    c.section = coin(random) ? 1 + 1e-15 : 1 + std::exp(log_scale(random));
    return c;
}

void expect_law(const TimeLaw& law, const Case& c, double duration_s) {
    const auto what = [&] {
        return testing::Message() << "length " << c.length << " speed " << c.speed << " acceleration "
                                  << c.acceleration << " stretch " << c.section;
    };
    ASSERT_EQ(law.duration_s(), duration_s) << what();
    ASSERT_LE(law.peak_speed(), c.speed * (1 + kRelative)) << what();
    double before = 0;
    for (int i = 0; i <= 300; ++i) {
        const LawState state = law.at(duration_s * i / 300);
        ASSERT_GE(state.s, before * (1 - 1e-12)) << what();
        ASSERT_LE(state.v, law.peak_speed() * (1 + kRelative)) << what();
        ASSERT_LE(std::abs(state.a), c.acceleration * (1 + kRelative)) << what();
        before = state.s;
    }
    ASSERT_EQ(law.at(duration_s).s, c.length) << what();
    ASSERT_EQ(law.at(0).v, 0) << what();
    ASSERT_NEAR(law.at(duration_s).v, 0, 1e-9 * law.peak_speed()) << what();
}

TEST(TimeLaw, RandomLawsKeepLimitsAndDuration) {
    std::mt19937 random(21);
    for (int i = 0; i < 20'000; ++i) {
        const Case c = random_case(random);
        const double fastest_s = trapezoid_s(c.length, c.speed, c.acceleration);
        ASSERT_NEAR(TimeLaw::fastest_s(c.length, c.speed, c.acceleration), fastest_s, 1e-12 * fastest_s);
        const TimeLaw fastest = TimeLaw::fastest(c.length, c.speed, c.acceleration);
        expect_law(fastest, c, TimeLaw::fastest_s(c.length, c.speed, c.acceleration));
        const double longer_s = fastest.duration_s() * c.section;
        expect_law(TimeLaw::with_duration(c.length, longer_s, c.acceleration, c.speed), c, longer_s);
        if (HasFatalFailure()) return;
    }
}

TEST(TimeLaw, DistanceIsIntegralOfSpeed) {
    std::mt19937 random(22);
    for (int i = 0; i < 300; ++i) {
        const Case c = random_case(random);
        const TimeLaw law = TimeLaw::with_duration(
            c.length, c.section * trapezoid_s(c.length, c.speed, c.acceleration), c.acceleration);
        for (const double share : {0.2, 0.5, 0.9, 1.0}) {
            const double t = share * law.duration_s();
            ASSERT_NEAR(law.at(t).s, integrated(law, t), 1e-3 * c.length)
                << c.length << ' ' << c.acceleration;
        }
    }
}

}  // namespace
}  // namespace gsim::motion::time_law_test
