#include "motion/profile/s_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "motion/profile/time_law.h"
#include "tests/motion/law_cases.h"
#include "tests/motion/law_reference.h"

namespace gsim::motion::s_curve_test {
namespace {

constexpr double kRelative = 1e-9;

TimeLaw make_law(const LawCase& c) {
    return TimeLaw::between(c.length, c.start, c.end, c.limits);
}

// Expects that each part ends at the start of the next.
void expect_continuous(const TimeLaw& law, const LawCase& c) {
    LawState at{0, c.start, 0};
    const double fastest = law.peak_speed();
    const bool finite_jerk = std::isfinite(c.limits.jerk);
    for (const LawSection& section : law.sections()) {
        const double t = section.duration_s;
        ASSERT_GT(t, 0) << what(c);
        ASSERT_NEAR(section.s0, at.s, kRelative) << what(c);
        ASSERT_NEAR(section.v0, at.v, kRelative * fastest) << what(c);
        if (finite_jerk) {
            ASSERT_NEAR(section.a0, at.a, kRelative * law.peak_acceleration()) << what(c);
        }
        at = {section.s0 + section.v0 * t + section.a0 * t * t / 2 + section.jerk * t * t * t / 6,
              section.v0 + section.a0 * t + section.jerk * t * t / 2, section.a0 + section.jerk * t};
    }
    ASSERT_NEAR(at.s, c.length, kRelative) << what(c);
    ASSERT_NEAR(at.v, c.end, kRelative * fastest) << what(c);
    if (finite_jerk) {
        ASSERT_NEAR(at.a, 0, kRelative * law.peak_acceleration()) << what(c);
    }
    ASSERT_EQ(law.at(law.duration_s()).s, c.length) << what(c);
}

void expect_limits(const TimeLaw& law, const LawCase& c, double relative = kRelative) {
    constexpr int kSamples = 24;
    const double speed = std::max({c.limits.max_speed, c.start, c.end}) * (1 + relative);
    for (const LawSection& section : law.sections())
        ASSERT_LE(std::abs(section.jerk), c.limits.jerk * (1 + 2 * relative)) << what(c);
    ASSERT_LE(law.peak_speed(), speed) << what(c);
    double before = 0;
    for (int i = 0; i <= kSamples; ++i) {
        const LawState state = law.at(law.duration_s() * i / kSamples);
        ASSERT_GE(state.s, before) << what(c);
        ASSERT_LE(state.v, speed) << what(c);
        ASSERT_LE(state.v, law.peak_speed() * (1 + kRelative)) << what(c);
        ASSERT_LE(state.a, c.limits.acceleration * (1 + relative)) << what(c);
        ASSERT_GE(state.a, -c.limits.deceleration * (1 + relative)) << what(c);
        before = state.s * (1 - 1e-12);
    }
}

// Returns true if the speed of a law jumps; only the others have joins.
bool jumps(const LawLimits& limits) {
    return std::isinf(limits.jerk) && (std::isinf(limits.acceleration) || std::isinf(limits.deceleration));
}

TEST(SCurve, SevenSectionsMatchHandCalculation) {
    // 1 s each: up to 8 mm/s2 and down again, with 2 s between, twice; cruise at 24 mm/s for 3 s.
    const TimeLaw law = TimeLaw::between(168, 0, 0, {24, 8, 8, 8});
    EXPECT_EQ(law.sections().size(), 7U);
    EXPECT_DOUBLE_EQ(law.duration_s(), 11);
    EXPECT_DOUBLE_EQ(law.peak_speed(), 24);
    EXPECT_DOUBLE_EQ(law.peak_acceleration(), 8);
    EXPECT_DOUBLE_EQ(law.at(1).v, 4);
    EXPECT_DOUBLE_EQ(law.at(1).s, 8.0 / 6);
    EXPECT_DOUBLE_EQ(law.at(2).a, 8);
    EXPECT_DOUBLE_EQ(law.at(5.5).s, 84);
    EXPECT_DOUBLE_EQ(law.at(9).a, -8);
}

TEST(SCurve, FourSectionsMatchHandCalculation) {
    // Four phases of 1 s at 6 mm/s3: 1 + 5 + 5 + 1 mm.
    const TimeLaw law = TimeLaw::between(12, 0, 0, {1000, 1000, 1000, 6});
    EXPECT_DOUBLE_EQ(law.duration_s(), 4);
    EXPECT_DOUBLE_EQ(law.peak_speed(), 6);
    EXPECT_DOUBLE_EQ(law.at(1).s, 1);
    EXPECT_DOUBLE_EQ(law.at(2).s, 6);
}

TEST(SCurve, RestToRestTakesMinimumTimeOfClosedForm) {
    LawCases cases(41);
    for (int i = 0; i < 100'000; ++i) {
        const LawCase c = cases.rest_to_rest();
        const TimeLaw law = make_law(c);
        ASSERT_NEAR(law.duration_s(), static_cast<double>(least_rest_to_rest_s(c)), 1e-9) << what(c);
        expect_limits(law, c);
        if (!jumps(c.limits)) expect_continuous(law, c);
        if (HasFatalFailure()) return;
    }
}

TEST(SCurve, EqualLimitsWithoutJerkGiveTrapezoid) {
    LawCases cases(42);
    for (int i = 0; i < 10'000; ++i) {
        LawCase c = cases.rest_to_rest();
        c.limits.jerk = kInfinity;
        c.limits.deceleration = c.limits.acceleration;
        const double expected_s = TimeLaw::fastest_s(c.length, c.limits.max_speed, c.limits.acceleration);
        ASSERT_NEAR(make_law(c).duration_s(), expected_s, 1e-12 * expected_s) << what(c);
    }
}

TEST(SCurve, NonzeroEndSpeedsKeepLimitsAndJoin) {
    LawCases cases(43);
    for (int i = 0; i < 50'000; ++i) {
        const LawCase c = cases.moving();
        const TimeLaw law = make_law(c);
        ASSERT_EQ(law.start_speed(), c.start);
        ASSERT_EQ(law.end_speed(), c.end);
        expect_limits(law, c);
        if (!jumps(c.limits)) expect_continuous(law, c);
        if (HasFatalFailure()) return;
    }
}

TEST(SCurve, NonzeroEndSpeedsTakeMinimumTimeAndPeakConverges) {
    LawCases cases(44);
    for (int i = 0; i < 10'000; ++i) {
        const LawCase c = cases.moving();
        if (jumps(c.limits)) continue;
        const TimeLaw law = make_law(c);
        const auto expected_s = static_cast<double>(least_time_s(c));
        ASSERT_NEAR(law.duration_s(), expected_s, 2e-12 * expected_s) << what(c);
        const auto peak = static_cast<double>(bisected_peak(c));
        ASSERT_NEAR(law.peak_speed(), peak, 1e-12 * peak) << what(c);
    }
}

TEST(SCurve, HigherPeakSpeedWouldOvershoot) {
    LawCases cases(45);
    for (int i = 0; i < 20'000; ++i) {
        const LawCase c = i % 2 == 0 ? cases.moving() : cases.rest_to_rest();
        const double peak = make_law(c).peak_speed();
        if (jumps(c.limits) || peak >= c.limits.max_speed * (1 - 1e-9)) continue;
        ASSERT_GT(through(peak * (1 + 1e-9), c).length, c.length) << what(c);
    }
}

// The test is not only for laws with one peak: no motion through two random speeds, with cruises at both, is
// faster.
TEST(SCurve, NoMotionOfThreeRampsIsFaster) {
    LawCases cases(46);
    for (int i = 0; i < 50'000; ++i) {
        LawCase c = cases.moving();
        if (jumps(c.limits)) continue;
        const double peak = make_law(c).peak_speed();
        const double fastest = std::min(c.limits.max_speed, 2 * peak);
        const double speeds[] = {c.start, fastest * cases.share(), fastest * cases.share(), c.end};
        Real length = 0;
        Real time_s = 0;
        for (int k = 0; k < 3; ++k) {
            const double limit = speeds[k] < speeds[k + 1] ? c.limits.acceleration : c.limits.deceleration;
            const Real ramp_s = time_of(std::abs(Real{speeds[k + 1]} - speeds[k]), limit, c.limits.jerk);
            length += (Real{speeds[k]} + speeds[k + 1]) / 2 * ramp_s;
            time_s += ramp_s;
        }
        const double cruise = cases.chance(0.5) ? 0 : cases.share() * static_cast<double>(length);
        c.length = static_cast<double>(length) + cruise;
        time_s += cruise / std::max(speeds[1], speeds[2]);
        ASSERT_LE(make_law(c).duration_s(), time_s * (1 + 3e-12L)) << what(c);
    }
}

TEST(SCurve, HigherLimitsNeverCostTime) {
    LawCases cases(47);
    for (int i = 0; i < 20'000; ++i) {
        const LawCase c = cases.moving();
        const double before_s = make_law(c).duration_s();
        for (double LawLimits::*limit :
             {&LawLimits::max_speed, &LawLimits::acceleration, &LawLimits::deceleration, &LawLimits::jerk}) {
            LawCase higher = c;
            higher.limits.*limit *= cases.chance(0.1) ? kInfinity : 1 + cases.log_uniform(1e-6, 10);
            ASSERT_LE(make_law(higher).duration_s(), before_s * (1 + 2e-12)) << what(higher);
        }
    }
}

TEST(SCurve, PositionsAndSpeedsAreIntegralsOfJerk) {
    LawCases cases(48);
    for (int i = 0; i < 3000; ++i) {
        LawCase c = cases.moving();
        if (std::isinf(c.limits.jerk)) c.limits.jerk = 1e4;
        const TimeLaw law = make_law(c);
        // The last bit of the jerks leaves a small acceleration, which accumulates over a long cruise.
        const double standstill = 4e-16 * law.peak_acceleration();
        const double tolerance_v = 1e-12 * law.peak_speed() + standstill * law.duration_s();
        const double tolerance_s = 1e-9 + standstill * law.duration_s() * law.duration_s();
        Real s = 0;
        Real v = c.start;
        Real a = 0;
        Real t_s = 0;
        constexpr int kSteps = 100;
        for (const LawSection& section : law.sections()) {
            const Real dt = Real{section.duration_s} / kSteps;
            for (int k = 0; k < kSteps; ++k) {  // Simpson's rule, exact for the speeds between
                const Real middle_v = v + (a + section.jerk * dt / 4) * dt / 2;
                const Real next_v = v + (a + section.jerk * dt / 2) * dt;
                s += dt / 6 * (v + 4 * middle_v + next_v);
                v = next_v;
                a += section.jerk * dt;
                t_s += dt;
                const LawState state = law.at(static_cast<double>(t_s));
                ASSERT_NEAR(state.s, static_cast<double>(s), tolerance_s) << what(c);
                ASSERT_NEAR(state.v, static_cast<double>(v), tolerance_v) << what(c);
            }
        }
        ASSERT_NEAR(static_cast<double>(a), 0, 1e-9 * law.peak_acceleration()) << what(c);
    }
}

TEST(SCurve, TimeReversalEqualsLawWithSwappedEnds) {
    LawCases cases(49);
    for (int i = 0; i < 20'000; ++i) {
        const LawCase c = cases.moving();
        const LawCase back{c.length,
                           c.end,
                           c.start,
                           {c.limits.max_speed, c.limits.deceleration, c.limits.acceleration, c.limits.jerk}};
        const TimeLaw law = make_law(c);
        const TimeLaw reversed = make_law(back);
        ASSERT_NEAR(law.duration_s(), reversed.duration_s(), 1e-12 * law.duration_s()) << what(c);
        if (jumps(c.limits)) continue;
        for (const double share : {0.1, 0.35, 0.6, 0.9}) {
            const LawState there = law.at(share * law.duration_s());
            const LawState mirrored = reversed.at((1 - share) * reversed.duration_s());
            ASSERT_NEAR(there.s, c.length - mirrored.s, 1e-11 * c.length) << what(c);
            ASSERT_NEAR(there.v, mirrored.v, 1e-9 * law.peak_speed()) << what(c);
        }
    }
}

TEST(SCurve, RampLengthGivesSingleRamp) {
    LawCases cases(50);
    for (int i = 0; i < 50'000; ++i) {
        LawCase c = cases.moving();
        const double limit = c.start < c.end ? c.limits.acceleration : c.limits.deceleration;
        c.length = ramp_length(c.start, c.end, limit, c.limits.jerk);
        if (c.length == 0) continue;
        const TimeLaw law = make_law(c);
        ASSERT_LE(law.sections().size(), 3U) << what(c);
        ASSERT_NEAR(law.duration_s(), ramp_s(c.start, c.end, limit, c.limits.jerk), 1e-12 * law.duration_s())
            << what(c);
        ASSERT_EQ(law.peak_speed(), std::max(c.start, c.end)) << what(c);
    }
}

TEST(SCurve, AbsorbsShortfallWithinRounding) {
    LawCases cases(51);
    for (int i = 0; i < 50'000; ++i) {
        LawCase c = cases.chance(0.3) ? cases.too_fast() : cases.moving();
        const double limit = c.start < c.end ? c.limits.acceleration : c.limits.deceleration;
        c.length = ramp_length(c.start, c.end, limit, c.limits.jerk) * (1 - 1e-9 * cases.share());
        if (c.length == 0) continue;
        const TimeLaw law = make_law(c);
        expect_limits(law, c, 1.1e-9);
        expect_continuous(law, c);
        if (HasFatalFailure()) return;
    }
}

TEST(SCurve, LargeShortfallStillJoins) {
    LawCases cases(52);
    for (int i = 0; i < 10'000; ++i) {
        LawCase c = cases.chance(0.3) ? cases.too_fast() : cases.moving();
        if (jumps(c.limits) || c.start == c.end) continue;
        const double limit = c.start < c.end ? c.limits.acceleration : c.limits.deceleration;
        c.length = ramp_length(c.start, c.end, limit, c.limits.jerk) * cases.log_uniform(1e-6, 1);
        expect_continuous(make_law(c), c);
        if (HasFatalFailure()) return;
    }
}

TEST(SCurve, BrakesFirstIfStartIsTooFast) {
    LawCases cases(53);
    for (int i = 0; i < 20'000; ++i) {
        const LawCase c = cases.too_fast();
        const TimeLaw law = make_law(c);
        expect_continuous(law, c);
        expect_limits(law, c);
        if (HasFatalFailure()) return;
        double before = c.start;
        for (int k = 0; k <= 30; ++k) {
            const double v = law.at(law.duration_s() * k / 30).v;
            ASSERT_LE(v, before * (1 + 1e-9) + 1e-9 * c.start) << what(c);
            before = v;
        }
        const auto braking_length =
            ramp_length(c.start, c.limits.max_speed, c.limits.deceleration, c.limits.jerk);
        const double all =
            braking_length + ramp_length(c.limits.max_speed, c.end, c.limits.deceleration, c.limits.jerk);
        if (all > c.length) continue;
        const double braking_s = ramp_s(c.start, c.limits.max_speed, c.limits.deceleration, c.limits.jerk);
        ASSERT_NEAR(law.at(braking_s).v, c.limits.max_speed, 1e-6 * c.limits.max_speed) << what(c);
        ASSERT_NEAR(law.at(braking_s).s, braking_length, 1e-9 * c.length) << what(c);
    }
}

TEST(SCurve, TinyLengthsAtHighSpeedKeepLimits) {
    LawCases cases(54);
    for (int i = 0; i < 50'000; ++i) {
        LawCase c = cases.rest_to_rest();
        if (std::isinf(c.limits.max_speed)) c.limits.max_speed = 2000;
        c.start = c.end = c.limits.max_speed * 0.999;
        c.length = cases.log_uniform(1e-12, 1e-3);
        const TimeLaw law = make_law(c);
        expect_limits(law, c);
        ASSERT_NEAR(law.duration_s(), c.length / c.start, 0.1 * c.length / c.start) << what(c);
        if (HasFatalFailure()) return;
    }
}

TEST(SCurve, ZeroLengthTakesNoTime) {
    const TimeLaw law = TimeLaw::between(0, 5, 7, {10, 10, 10, 10});
    EXPECT_EQ(law.duration_s(), 0);
    EXPECT_EQ(law.start_speed(), 5);
    EXPECT_EQ(law.end_speed(), 7);
    EXPECT_EQ(law.at(0).s, 0);
    EXPECT_EQ(law.at(0).v, 7);
    const TimeLaw cruise = TimeLaw::between(20, 10, 10, {10, 10, 10, 10});
    EXPECT_EQ(cruise.sections().size(), 1U);
    EXPECT_DOUBLE_EQ(cruise.duration_s(), 2);
    EXPECT_EQ(TimeLaw::between(20, 0, 0, {kInfinity, kInfinity, kInfinity, kInfinity}).at(0).s, 20);
}

TEST(SCurve, OddValuesNeitherHangNorCrash) {
    const double odd[] = {0, -1, 1, 1e-300, 1e300, kInfinity, std::numeric_limits<double>::quiet_NaN()};
    for (const double length : odd) {
        for (const double start : odd) {
            for (const double end : odd) {
                for (const double speed : odd) {
                    for (const double a : odd) {
                        for (const double jerk : odd)
                            TimeLaw::between(length, start, end, {speed, a, 1, jerk}).at(0.5);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace gsim::motion::s_curve_test
