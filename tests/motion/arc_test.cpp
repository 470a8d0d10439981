#include "motion/path/arc.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace gsim::motion::arc_test {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

Arc random_arc(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(number(random), number(random), number(random), number(random)).normalized();
    std::bernoulli_distribution coin(0.5);
    Arc arc;
    arc.center = 100 * Vector3d(number(random), number(random), number(random));
    arc.u = turn * Vector3d::UnitX();
    arc.v = turn * Vector3d::UnitY();
    arc.radius_mm = arc.end_radius_mm = 30 + 25 * number(random);
    arc.sweep_rad = 8 + 7.9 * number(random);
    if (coin(random)) arc.end_radius_mm += coin(random) ? 5 * number(random) : 1e-8;
    if (coin(random)) arc.lift = 20 * number(random) * (turn * Vector3d::UnitZ());
    return arc;
}

TEST(Arc, QuarterCircleMatchesHandCalculation) {
    const Arc arc{.center = {10, 0, 5}, .radius_mm = 2, .end_radius_mm = 2, .sweep_rad = kPi / 2};
    EXPECT_DOUBLE_EQ(arc.length_mm(), kPi);
    EXPECT_TRUE(arc.at(0).isApprox(Vector3d(12, 0, 5)));
    EXPECT_TRUE(arc.at(kPi / 2).isApprox(Vector3d(10, 2, 5)));
    EXPECT_TRUE(arc.tangent(0).isApprox(Vector3d::UnitY()));
    EXPECT_TRUE(arc.curvature(0).isApprox(Vector3d(-0.5, 0, 0)));
    EXPECT_DOUBLE_EQ(arc.max_curvature(), 0.5);
    EXPECT_DOUBLE_EQ(arc.phi_at(kPi / 2), kPi / 4);
}

TEST(Arc, HelixMatchesHandCalculation) {
    // One turn of radius 3 that climbs 8 pi: its unrolled length is hypot(6 pi, 8 pi).
    const Arc arc{.radius_mm = 3, .end_radius_mm = 3, .sweep_rad = 2 * kPi, .lift = {0, 0, 8 * kPi}};
    EXPECT_DOUBLE_EQ(arc.length_mm(), 10 * kPi);
    EXPECT_TRUE(arc.tangent(0).isApprox(Vector3d(0, 0.6, 0.8)));
    EXPECT_TRUE(arc.at(kPi).isApprox(Vector3d(-3, 0, 4 * kPi)));
    EXPECT_DOUBLE_EQ(arc.max_share(2), 0.8);
    EXPECT_DOUBLE_EQ(arc.max_share(0), 0.6);
}

TEST(Arc, SpiralGoesFromStartRadiusToEndRadius) {
    const Arc arc{.radius_mm = 10, .end_radius_mm = 10.01, .sweep_rad = kPi};
    EXPECT_TRUE(arc.at(0).isApprox(Vector3d(10, 0, 0)));
    EXPECT_LT((arc.at(kPi) - Vector3d(-10.01, 0, 0)).norm(), 1e-12);
    EXPECT_NEAR(arc.at(arc.phi_at(arc.length_mm() / 2)).norm(), 10.005, 1e-12);
}

TEST(Arc, IsParameterizedByArcLength) {
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        const Arc arc = random_arc(random);
        const double length = arc.length_mm();
        const double step = length / 20'000;
        for (const double share : {0.0, 0.1, 0.37, 0.5, 0.92}) {
            const double s = share * length;
            const Vector3d a = arc.at(arc.phi_at(s)), b = arc.at(arc.phi_at(s + step));
            ASSERT_NEAR((b - a).norm(), step, 1e-5 * step) << "arc " << i << " share " << share;
            ASSERT_LT(((b - a) / step - arc.tangent(arc.phi_at(s + step / 2))).norm(), 1e-5) << "arc " << i;
            const Vector3d measured_curvature =
                (arc.tangent(arc.phi_at(s + step)) - arc.tangent(arc.phi_at(s))) / step;
            ASSERT_LT((measured_curvature - arc.curvature(arc.phi_at(s + step / 2))).norm(), 1e-5)
                << "arc " << i;
            ASSERT_LE(measured_curvature.norm(), arc.max_curvature() * (1 + 1e-6)) << "arc " << i;
        }
        ASSERT_NEAR(arc.phi_at(length), arc.sweep_rad, 1e-12 * arc.sweep_rad);
    }
}

TEST(Arc, TangentIsUnitVectorWithinMaxShares) {
    std::mt19937 random(6);
    for (int i = 0; i < 500; ++i) {
        const Arc arc = random_arc(random);
        for (int k = 0; k <= 50; ++k) {
            const Vector3d tangent = arc.tangent(arc.sweep_rad * k / 50);
            ASSERT_NEAR(tangent.norm(), 1, 1e-12) << "arc " << i;
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_LE(std::abs(tangent[axis]), arc.max_share(axis) * (1 + 1e-12)) << "arc " << i;
            }
        }
    }
}

TEST(Arc, BulgeBoundsExtentBeyondEnds) {
    std::mt19937 random(11);
    for (int i = 0; i < 500; ++i) {
        Arc arc = random_arc(random);
        if (i % 2 == 0) arc.sweep_rad /= 20;
        arc.lift.setZero();
        for (int axis = 0; axis < 3; ++axis) {
            const double start = arc.at(0)[axis], end = arc.at(arc.sweep_rad)[axis];
            const Range range = arc.range(axis);
            ASSERT_GE(range.min, std::min(start, end) - arc.bulge_mm() - 1e-9) << "arc " << i;
            ASSERT_LE(range.max, std::max(start, end) + arc.bulge_mm() + 1e-9) << "arc " << i;
        }
    }
}

TEST(Arc, BulgeOfShortArcIsHeightAboveChord) {
    const double sweep_rad = 0.1;
    const Arc arc{.radius_mm = 50, .end_radius_mm = 50, .sweep_rad = sweep_rad};
    EXPECT_NEAR(arc.bulge_mm(), 50 * (1 - std::cos(sweep_rad / 2)), 1e-4);
}

// The path length is change / log(end / start) times the sweep, in long double here; the series passes into
// the logarithm without a step.
TEST(Arc, LengthIsExactForNearlyCircularSpiral) {
    for (double growth = 1e-13; growth < 0.1; growth *= 1.7) {
        const double radius_mm = 30, sweep_rad = 2, change_mm = radius_mm * growth;
        const Arc arc{.radius_mm = radius_mm, .end_radius_mm = radius_mm + change_mm, .sweep_rad = sweep_rad};
        const long double change = static_cast<long double>(arc.end_radius_mm) - radius_mm;
        const long double around = sweep_rad * change / std::log1p(change / radius_mm);
        ASSERT_NEAR(arc.length_mm(), static_cast<double>(std::hypot(around, change)), 1e-13) << growth;
    }
}

TEST(Arc, RangeMatchesDenseSamples) {
    std::mt19937 random(7);
    for (int i = 0; i < 500; ++i) {
        const Arc arc = random_arc(random);
        for (int axis = 0; axis < 3; ++axis) {
            const Range range = arc.range(axis);
            double low = arc.at(0)[axis], high = low;
            for (int k = 0; k <= 5000; ++k) {
                const double value = arc.at(arc.sweep_rad * k / 5000)[axis];
                low = std::min(low, value);
                high = std::max(high, value);
            }
            ASSERT_LE(range.min, low + 1e-9) << "arc " << i << " axis " << axis;
            ASSERT_GE(range.max, high - 1e-9) << "arc " << i << " axis " << axis;
            ASSERT_LE(arc.bounds(axis).min, range.min + 1e-9) << "arc " << i << " axis " << axis;
            ASSERT_GE(arc.bounds(axis).max, range.max - 1e-9) << "arc " << i << " axis " << axis;
            ASSERT_NEAR(range.min, low, 1e-3) << "arc " << i << " axis " << axis;
            ASSERT_NEAR(range.max, high, 1e-3) << "arc " << i << " axis " << axis;
        }
    }
}

}  // namespace
}  // namespace gsim::motion::arc_test
