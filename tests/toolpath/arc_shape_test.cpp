#include "toolpath/model/arc_shape.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace gsim::path::arc_shape_test {
namespace {

using Eigen::Vector3d;

// A circle that was chosen first: its arc through any third point is found again, on the side of that point.
TEST(ArcShape, FindsCircleThroughViaPoint) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const Vector3d center = 500 * Vector3d(number(random), number(random), number(random));
        const Vector3d normal = Vector3d(number(random), number(random), number(random)).normalized();
        const Vector3d first = normal.unitOrthogonal() * (50 + 45 * number(random));
        const double turn = std::numbers::pi * (1 + 0.95 * number(random));
        const double share = 0.5 + 0.4 * number(random);
        const auto on_circle = [&](double angle) -> Vector3d {
            return center + Eigen::AngleAxisd(angle, normal) * first;
        };
        const Vector3d start = on_circle(0), via = on_circle(share * turn), end = on_circle(turn);
        Point point;
        point.motion = MotionType::circular;
        point.position_mm = {end.x(), end.y(), end.z()};
        point.arc = ViaPoint{{via.x(), via.y(), via.z()}};
        const ArcShape arc = arc_shape({start.x(), start.y(), start.z()}, point).value();
        EXPECT_LT((arc.center - center).norm(), 1e-6);
        EXPECT_LT((arc.normal - normal).norm(), 1e-8);
        EXPECT_NEAR(arc.turn_rad, turn, 1e-8);
        EXPECT_LT((arc.at(0) - start).norm(), 1e-6);
        EXPECT_LT((arc.at(share) - via).norm(), 1e-6);
        EXPECT_LT((arc.at(1) - end).norm(), 1e-6);
    }
}

TEST(ArcShape, HelixOfSeveralTurnsReachesEndPoint) {
    Point point;
    point.motion = MotionType::circular;
    point.position_mm = {0, 10, 30};
    point.arc = CenterArc{{0, 0, 7}, {0, 0, 2}, 810};
    const ArcShape arc = arc_shape({10, 0, 0}, point).value();
    EXPECT_NEAR(arc.rise_mm, 30, 1e-12);
    EXPECT_LT((arc.at(1) - Vector3d(0, 10, 30)).norm(), 1e-9);
    EXPECT_LT((arc.at(4.0 / 9) - Vector3d(10, 0, 30 * 4.0 / 9)).norm(), 1e-9) << "after one whole turn";
}

}  // namespace
}  // namespace gsim::path::arc_shape_test
