#include "cam/waterjet/jet_lag.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "sample.h"

namespace gsim::waterjet::jet_lag_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double uniform(std::mt19937& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

// The end of a tangent of the allowed length is off the circle by the allowed error.
TEST(JetLag, ExitDeviatesByAllowedErrorOnArc) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const double radius = uniform(random, 0, 50);
        const double error = uniform(random, 0.01, 1);
        EXPECT_NEAR(std::hypot(radius, lag_allowed_on_arc_mm(radius, error)) - radius, error, 1e-9);
    }
}

// The chord from L before the corner to L after it passes the corner at the allowed error.
TEST(JetLag, ExitCutsCornerByAllowedError) {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const double turn = uniform(random, 0.01, kPi - 0.01);
        const double error = uniform(random, 0.01, 1);
        const double lag = lag_allowed_in_corner_mm(turn, error);
        const double middle_x = (-lag + lag * std::cos(turn)) / 2;  // of the chord; the corner is the origin
        const double middle_y = lag * std::sin(turn) / 2;
        EXPECT_NEAR(std::hypot(middle_x, middle_y), error, 1e-9);
    }
}

TEST(JetLag, SpeedAndLagAreInverse) {
    const LagRule& rule = sample_materials().lag;
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const StraightCut cut{uniform(random, 1, 100), uniform(random, 10, 5000)};
        const double speed = uniform(random, 1, 5000);
        EXPECT_NEAR(speed_for_lag_mm_min(rule, cut, lag_mm(rule, cut, speed)), speed, 1e-9 * speed);
    }
    EXPECT_NEAR(lag_mm(rule, {10, 200}, 200), 10 * rule.lag_to_thickness, 1e-12);
}

TEST(JetLag, InterpolatesErrorBetweenQualities) {
    LagRule rule;
    rule.contour_error_mm = {0.5, 0.4, 0.2, 0.1, 0.05};
    EXPECT_DOUBLE_EQ(contour_error_mm(rule, 1), 0.5);
    EXPECT_DOUBLE_EQ(contour_error_mm(rule, 2.5), 0.3);
    EXPECT_DOUBLE_EQ(contour_error_mm(rule, 5), 0.05);
}

// In the sample file the lag varies with 1 / quality, because the speed's power and the lag's are inverse.
TEST(JetLag, IsInverselyProportionalToQuality) {
    const double separation = sample_plan("mild steel", 20, 1).lag_mm;
    for (const double quality : {1.0, 2.0, 3.0, 5.0})
        EXPECT_NEAR(sample_plan("mild steel", 20, quality).lag_mm * quality, separation, 0.01 * separation);
}

TEST(FeedForRadius, GrowsWithRadiusUpToCuttingSpeed) {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        const CuttingPlan plan =
            sample_plan("stainless steel", uniform(random, 0.5, 100), uniform(random, 1, 5));
        double before = plan.lag.min_feed_share * plan.cutting_speed_mm_min;
        for (double radius = 0; radius < 500; radius += 2.5) {
            const double feed = feed_for_radius_mm_min(plan, radius);
            EXPECT_GE(feed, before);
            EXPECT_LE(feed, plan.cutting_speed_mm_min);
            before = feed;
        }
        EXPECT_DOUBLE_EQ(feed_for_radius_mm_min(plan, kInfinity), plan.cutting_speed_mm_min);
    }
}

// Wherever the feed is not at one of its ends, the lag shows by the allowed error, no more and no less.
TEST(FeedForRadius, UsesFullAllowedError) {
    const CuttingPlan plan = sample_plan("stainless steel", 25, 3);
    const StraightCut cut{plan.thickness_mm, plan.separation_speed_mm_min};
    int between = 0;
    for (double radius = 0.5; radius < 50; radius += 0.5) {
        const double feed = feed_for_radius_mm_min(plan, radius);
        const double lag = lag_mm(plan.lag, cut, feed);
        const double error = std::hypot(radius, lag) - radius;
        if (feed < plan.cutting_speed_mm_min) {
            EXPECT_NEAR(error, plan.contour_error_mm, 1e-9);
            ++between;
        } else {
            EXPECT_LE(error, plan.contour_error_mm + 1e-9);
        }
    }
    EXPECT_GT(between, 10);
}

TEST(FeedForCorner, DecreasesWithCornerAngle) {
    const CuttingPlan plan = sample_plan("aluminum", 40, 3);
    EXPECT_DOUBLE_EQ(feed_for_corner_mm_min(plan, 0), plan.cutting_speed_mm_min);
    double before = plan.cutting_speed_mm_min;
    for (double turn = 0; turn <= kPi; turn += kPi / 64) {
        const double feed = feed_for_corner_mm_min(plan, turn);
        EXPECT_LE(feed, before);
        EXPECT_DOUBLE_EQ(feed, feed_for_corner_mm_min(plan, -turn));
        before = feed;
    }
    EXPECT_LT(before, 0.5 * plan.cutting_speed_mm_min);
    EXPECT_GE(before, plan.lag.min_feed_share * plan.cutting_speed_mm_min);
}

TEST(Feed, CornerFeedIsReducedOnlyInThickMaterial) {
    const CuttingPlan thin = sample_plan("aluminum", 0.5, 3);
    EXPECT_DOUBLE_EQ(feed_for_corner_mm_min(thin, kPi / 2), thin.cutting_speed_mm_min)
        << "no lag to speak of";
    const CuttingPlan thick = sample_plan("aluminum", 150, 3);
    EXPECT_LT(feed_for_corner_mm_min(thick, kPi / 2), 0.2 * thick.cutting_speed_mm_min);
}

TEST(Feed, InvalidValuesGiveLowestFeed) {
    const CuttingPlan plan = sample_plan("aluminum", 40, 3);
    EXPECT_DOUBLE_EQ(feed_for_radius_mm_min(plan, kNaN), feed_for_radius_mm_min(plan, 0));
    EXPECT_DOUBLE_EQ(feed_for_radius_mm_min(plan, -1), feed_for_radius_mm_min(plan, 0));
    EXPECT_DOUBLE_EQ(feed_for_corner_mm_min(plan, kNaN), feed_for_corner_mm_min(plan, kPi));
    EXPECT_DOUBLE_EQ(feed_for_corner_mm_min(plan, kInfinity), feed_for_corner_mm_min(plan, kPi));
}

}  // namespace
}  // namespace gsim::waterjet::jet_lag_test
