#include "motion/path/circle.h"

#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::motion::circle_test {
namespace {

using Eigen::Vector3d;
using rrs::Status;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance_mm = 0.05;

Vector3d random_point(std::mt19937& random, double scale) {
    std::uniform_real_distribution<double> number(-scale, scale);
    return {number(random), number(random), number(random)};
}

TEST(ArcThrough, PassesViaPointBetweenStartAndEnd) {
    std::mt19937 random(9);
    for (int i = 0; i < 20'000; ++i) {
        const Vector3d a = random_point(random, 1000), b = random_point(random, 1000),
                       c = random_point(random, 1000);
        Arc arc;
        ASSERT_TRUE(arc_through(a, b, c, arc))
            << a.transpose() << " | " << b.transpose() << " | " << c.transpose();
        ASSERT_LT((arc.at(0) - a).norm(), 1e-6);
        ASSERT_LT((arc.at(arc.sweep_rad) - c).norm(), 1e-6);
        const Vector3d from_center = b - arc.center;
        const double phi = std::atan2(from_center.dot(arc.v), from_center.dot(arc.u));
        const double via = phi > 0 ? phi : phi + 2 * kPi;
        ASSERT_LT(via, arc.sweep_rad) << a.transpose() << " | " << b.transpose() << " | " << c.transpose();
        ASSERT_LT((arc.at(via) - b).norm(), 1e-6);
        ASSERT_LT(arc.sweep_rad, 2 * kPi);
    }
}

TEST(ArcThrough, ViaPointSelectsShortOrLongArc) {
    Arc arc;
    ASSERT_TRUE(arc_through({1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, arc));
    EXPECT_NEAR(arc.sweep_rad, 1.5 * kPi, 1e-12);
    ASSERT_TRUE(arc_through({1, 0, 0}, {std::sqrt(0.5), std::sqrt(0.5), 0}, {0, 1, 0}, arc));
    EXPECT_NEAR(arc.sweep_rad, 0.5 * kPi, 1e-12);
}

TEST(ArcThrough, IsExactIfNearlyStraight) {
    Arc arc;
    const Vector3d a(1000, 0, 0), b(1500, 0.001, 0), c(2000, 0, 0);
    ASSERT_TRUE(arc_through(a, b, c, arc));
    EXPECT_LT((arc.at(arc.sweep_rad / 2) - b).norm(), 1e-6);
    EXPECT_LT((arc.at(0) - a).norm(), 1e-6);
}

TEST(ArcThrough, RejectsCollinearOrCoincidentPoints) {
    const auto rejection = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        Arc arc;
        const PlanResult planned = arc_through(a, b, c, arc);
        EXPECT_EQ(planned.error().status, Status::RRS_CIRCLE_IMPOSSIBLE);
        return planned.error().message;
    };
    const std::string on_line =
        "The via point of the arc is on the straight line from its start to its target.";
    EXPECT_EQ(rejection({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), on_line);
    EXPECT_EQ(rejection({0.1, 0.2, 0.3}, {0.1 + 1e-3, 0.2 + 1e-3, 0.3 + 1e-3}, {1.1, 1.2, 1.3}), on_line);
    EXPECT_EQ(rejection({0, 0, 0}, {7, 7, 7}, {3, 3, 3}), on_line);
    const std::string coincide = "Start, via point and target of the arc must be three different points.";
    EXPECT_EQ(rejection({1, 2, 3}, {1, 2, 3}, {4, 5, 7}), coincide);
    EXPECT_EQ(rejection({1, 2, 3}, {4, 5, 7}, {4, 5, 7}), coincide);
    EXPECT_EQ(rejection({1, 2, 3}, {4, 5, 7}, {1, 2, 3}), coincide);
}

TEST(ArcAbout, KeepsStartAndEndOfRandomArcsAndHelices) {
    std::mt19937 random(10);
    std::uniform_real_distribution<double> sweep(0.001, 20);
    for (int i = 0; i < 20'000; ++i) {
        const Vector3d center = random_point(random, 1000), start = random_point(random, 1000);
        const Vector3d axis = random_point(random, 1).normalized();
        const double phi = sweep(random), rise = random_point(random, 50).x();
        const Vector3d end = center + Eigen::AngleAxisd(phi, axis) * (start - center) + rise * axis;
        Arc arc;
        ASSERT_TRUE(arc_about(start, end, center, axis, phi, kTolerance_mm, arc)) << "case " << i;
        ASSERT_NEAR(arc.sweep_rad, phi, 1e-9) << "case " << i;
        ASSERT_LT((arc.at(0) - start).norm(), 1e-9) << "case " << i;
        ASSERT_LT((arc.at(arc.sweep_rad) - end).norm(), 2e-9) << "case " << i;
        const double part = 0.3 * phi;
        const Vector3d expected =
            center + Eigen::AngleAxisd(part, axis) * (start - center) + 0.3 * rise * axis;
        ASSERT_LT((arc.at(part) - expected).norm(), 1e-6) << "case " << i;
    }
}

TEST(ArcAbout, AcceptsFullCirclesAndSeveralTurns) {
    Arc arc;
    ASSERT_TRUE(arc_about({5, 0, 0}, {5, 0, 0}, {0, 0, 0}, Vector3d::UnitZ(), 2 * kPi, kTolerance_mm, arc));
    EXPECT_NEAR(arc.length_mm(), 10 * kPi, 1e-12);
    ASSERT_TRUE(
        arc_about({5, 0, 0}, {-5, 0, 9}, {0, 0, 44}, -Vector3d::UnitZ(), 7 * kPi, kTolerance_mm, arc));
    EXPECT_NEAR(arc.sweep_rad, 7 * kPi, 1e-12);
    EXPECT_TRUE(arc.lift.isApprox(Vector3d(0, 0, 9)));
    EXPECT_TRUE(arc.v.isApprox(-Vector3d::UnitY()));
    EXPECT_EQ(arc.center.z(), 0);
}

TEST(ArcAbout, MakesSpiralToTargetIfRadiiDifferSlightly) {
    Arc arc;
    const Vector3d start(10, 0, 0), end(0, 10.01, 0);
    ASSERT_TRUE(arc_about(start, end, {0, 0, 0}, Vector3d::UnitZ(), kPi / 2, kTolerance_mm, arc));
    EXPECT_LT((arc.at(0) - start).norm(), 1e-12);
    EXPECT_LT((arc.at(arc.sweep_rad) - end).norm(), 1e-12);
}

TEST(ArcAbout, AdjustsSweepToTargetWithinTolerance) {
    Arc arc;
    const Vector3d end(10 * std::cos(1.001), 10 * std::sin(1.001), 0);
    ASSERT_TRUE(arc_about({10, 0, 0}, end, {0, 0, 0}, Vector3d::UnitZ(), 1, kTolerance_mm, arc));
    EXPECT_NEAR(arc.sweep_rad, 1.001, 1e-12);
}

TEST(ArcAbout, RejectsTargetOffCircle) {
    Arc arc;
    const auto rejection = [&](const Vector3d& end, const Vector3d& center, double sweep) {
        const PlanResult planned =
            arc_about({10, 0, 0}, end, center, Vector3d::UnitZ(), sweep, kTolerance_mm, arc);
        EXPECT_EQ(planned.error().status, Status::RRS_CIRCLE_IMPOSSIBLE);
        return planned.error().message;
    };
    EXPECT_THAT(rejection({0, 11, 0}, {0, 0, 0}, kPi / 2),
                HasSubstr("radius is 10 mm at its start but 11 mm at its end"));
    EXPECT_THAT(rejection({0, 10, 0}, {0, 0, 0}, 1), HasSubstr("from the end of its sweep of 1 rad"));
    EXPECT_EQ(rejection({0, 10, 0}, {10, 0, 5}, 1), "The centre of the arc coincides with its start.");
    EXPECT_THAT(rejection({0, 10, 0}, {1e12, 0, 0}, 1), HasSubstr("too large"));
}

TEST(ArcAbout, LimitsToleranceOfSmallCircles) {
    Arc arc;
    EXPECT_FALSE(
        arc_about({0.02, 0, 0}, {-0.02, 0, 0}, {0, 0, 0}, Vector3d::UnitZ(), 0.1, kTolerance_mm, arc));
    EXPECT_FALSE(
        arc_about({0.02, 0, 0}, {0, 0.06, 0}, {0, 0, 0}, Vector3d::UnitZ(), kPi / 2, kTolerance_mm, arc));
}

TEST(ArcAbout, RejectsInvalidNumbers) {
    Arc arc;
    const auto status = [&](const Vector3d& center, const Vector3d& axis, double sweep) {
        return arc_about({10, 0, 0}, {0, 10, 0}, center, axis, sweep, kTolerance_mm, arc).error().status;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(status({nan, 0, 0}, Vector3d::UnitZ(), 1), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(status({0, 0, 0}, {0, 0, 2}, 1), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(status({0, 0, 0}, {0, 0, nan}, 1), Status::RRS_INVALID_PARAMETER);
    for (const double sweep : {0.0, -1.0, nan, 1e300}) {
        EXPECT_EQ(status({0, 0, 0}, Vector3d::UnitZ(), sweep), Status::RRS_INVALID_PARAMETER) << sweep;
    }
}

}  // namespace
}  // namespace gsim::motion::circle_test
