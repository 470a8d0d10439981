// Arcs of centre, radius or angle: against the circle itself.

#include "runtime/script/words/arc_solution.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace gsim::script::arc_solution_test {
namespace {

using Eigen::Vector2d;

constexpr double kPi = std::numbers::pi;
constexpr int kCases = 2000;

Vector2d on_circle(const Vector2d& center, double radius, double angle) {
    return {center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle)};
}

// An arc made from its centre, so that everything about it is known.
struct KnownArc {
    Vector2d center;
    double radius;
    double sweep;
    ArcEnds ends;
};

class Random {
  public:
    KnownArc arc(double least_sweep = 0.01, double most_sweep = 2 * kPi - 0.01) {
        KnownArc arc;
        arc.center = {number(-500, 500), number(-500, 500)};
        arc.radius = number(0.5, 300);
        arc.sweep = number(least_sweep, most_sweep);
        const double from = number(-kPi, kPi);
        const bool ccw = number(0, 1) > 0.5;
        const double to = ccw ? from + arc.sweep : from - arc.sweep;
        arc.ends = {on_circle(arc.center, arc.radius, from), on_circle(arc.center, arc.radius, to), ccw};
        return arc;
    }

  private:
    double number(double min, double max) {
        return std::uniform_real_distribution<double>(min, max)(engine_);
    }
    std::mt19937 engine_{7};
};

void expect_solution(const Result<ArcSolution>& found, const KnownArc& arc) {
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_NEAR(found->center.x(), arc.center.x(), 1e-6);
    EXPECT_NEAR(found->center.y(), arc.center.y(), 1e-6);
    EXPECT_NEAR(found->sweep_rad, arc.sweep, 1e-6);
}

TEST(ArcSolution, FindsSweepFromCentre) {
    Random random;
    for (int i = 0; i < kCases; ++i) {
        const KnownArc arc = random.arc();
        expect_solution(arc_by_center(arc.ends, arc.center, {}, false), arc);
    }
}

TEST(ArcSolution, SignOfRadiusSelectsShorterOrLongerArc) {
    Random random;
    for (int i = 0; i < kCases; ++i) {
        const KnownArc shorter = random.arc(0.05, kPi - 0.05);
        expect_solution(arc_by_radius(shorter.ends, shorter.radius, {}), shorter);
        const KnownArc longer = random.arc(kPi + 0.05, 2 * kPi - 0.05);
        expect_solution(arc_by_radius(longer.ends, -longer.radius, {}), longer);
    }
}

TEST(ArcSolution, SolvesAngleWithEndOrCentre) {
    Random random;
    for (int i = 0; i < kCases; ++i) {
        const KnownArc arc = random.arc(0.05, 2 * kPi - 0.05);
        expect_solution(arc_by_angle(arc.ends, arc.sweep), arc);
        const Vector2d end = end_by_angle(arc.ends, arc.center, arc.sweep);
        EXPECT_NEAR((end - arc.ends.end).norm(), 0, 1e-9);
    }
}

TEST(ArcSolution, CoincidentEndsAreFullCircleOnlyByCentre) {
    const ArcEnds ends{{10, 0}, {10, 0}, true};
    EXPECT_DOUBLE_EQ(arc_by_center(ends, {0, 0}, {}, false)->sweep_rad, 2 * kPi);
    EXPECT_FALSE(arc_by_radius(ends, 10, {}));
    EXPECT_FALSE(arc_by_angle(ends, kPi));
    EXPECT_DOUBLE_EQ(swept_rad(ends, {0, 0}), 2 * kPi);
}

TEST(ArcSolution, AcceptsRadiiWithinToleranceOfUnits) {
    const ArcRules rules{.radii_tolerance_mm = 0.03,
                         .radii_tolerance_inch_mm = 0.07,
                         .radii_tolerance_share = 0.001,
                         .radii_tolerance_growth = 100};
    const auto differing = [](double by, double radius) {
        return ArcEnds{{radius, 0}, {0, radius + by}, true};
    };
    EXPECT_TRUE(arc_by_center(differing(0.029, 10), {0, 0}, rules, false));
    EXPECT_FALSE(arc_by_center(differing(0.031, 10), {0, 0}, rules, false));
    EXPECT_TRUE(arc_by_center(differing(0.069, 10), {0, 0}, rules, true));
    EXPECT_TRUE(arc_by_center(differing(0.9, 1000), {0, 0}, rules, false));   // 0.1 % of the radius
    EXPECT_FALSE(arc_by_center(differing(3.1, 5000), {0, 0}, rules, false));  // up to 3 mm
}

TEST(ArcSolution, SlightlyShortRadiusGivesHalfCircle) {
    const ArcEnds ends{{0, 0}, {20, 0}, true};
    const auto arc = arc_by_radius(ends, 9.96, {});
    ASSERT_TRUE(arc);
    EXPECT_DOUBLE_EQ(arc->sweep_rad, kPi);
    EXPECT_DOUBLE_EQ(arc->center.x(), 10);
    EXPECT_FALSE(arc_by_radius(ends, 9.94, {}));
}

TEST(ArcSolution, AcceptsOnlyIntegerTurnsWithinTolerance) {
    const ArcRules exact;
    const ArcRules near{.turns_tolerance = 1e-4};
    EXPECT_DOUBLE_EQ(*additional_turns_rad(1, exact), 0);
    EXPECT_DOUBLE_EQ(*additional_turns_rad(3, exact), 4 * kPi);
    EXPECT_DOUBLE_EQ(*additional_turns_rad(2.00009, near), 2 * kPi);
    EXPECT_DOUBLE_EQ(*additional_turns_rad(1.99991, near), 2 * kPi);
    for (const double turns :
         {0.0, -1.0, 1.5, 2.00001, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(additional_turns_rad(turns, exact)) << turns;
    EXPECT_FALSE(additional_turns_rad(1.5, near));
}

TEST(ArcSolution, AcceptsAnglesAboveZeroUpToFullTurn) {
    EXPECT_DOUBLE_EQ(*arc_angle_rad(360), 2 * kPi);
    for (const double degrees : {0.0, -10.0, 360.1, std::nan("")}) EXPECT_FALSE(arc_angle_rad(degrees));
}

TEST(ArcSolution, ReturnsForNonFiniteAndHugeNumbers) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const double odd : {std::nan(""), inf, -inf, 1e300, 0.0}) {
        const ArcEnds ends{{odd, 1}, {2, odd}, false};
        const auto by_center = arc_by_center(ends, {odd, 0}, {}, false);
        const auto by_radius = arc_by_radius(ends, odd, {});
        const auto by_angle = arc_by_angle(ends, 1);
        EXPECT_TRUE(!by_center || by_center->sweep_rad <= 2 * kPi);
        EXPECT_TRUE(by_radius || !by_radius.error().message.empty());
        EXPECT_TRUE(!by_angle || by_angle->sweep_rad == 1);
    }
}

}  // namespace
}  // namespace gsim::script::arc_solution_test
