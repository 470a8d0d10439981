// Distances from the path of the set points, against lines and circles.
#include "runtime/monitors/set_point_path.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace gsim::simulation {
namespace {

using Eigen::Vector3d;

TEST(SetPointPath, MeasuresDistanceFromPointAndLines) {
    SetPointPath path;
    path.begin({1, 2, 3});
    EXPECT_NEAR(path.distance_mm({1, 2, 7}), 4, 1e-12);
    path.add_line({11, 2, 3}, 1, false);
    path.add_line({11, 12, 3}, 2, false);
    EXPECT_NEAR(path.distance_mm({5, 1, 3}), 1, 1e-12);
    EXPECT_NEAR(path.distance_mm({14, 15, 3}), std::hypot(3, 3), 1e-12);
    EXPECT_NEAR(path.distance_mm({9, 5, 3}), 2, 1e-12);
    path.add_line({11, 32, 3}, 3, true);  // the last line is longer now
    EXPECT_NEAR(path.distance_mm({14, 30, 3}), 3, 1e-12);
}

TEST(SetPointPath, IgnoresDiscardedPart) {
    SetPointPath path;
    path.begin({0, 0, 0});
    path.add_line({10, 0, 0}, 1, false);
    path.add_line({10, 10, 0}, 2, false);
    path.discard_before(1.5);
    EXPECT_NEAR(path.distance_mm({2, 0, 0}), 8, 1e-12);
    path.discard_before(9);  // the last part stays
    EXPECT_NEAR(path.distance_mm({10, 5, 0}), 0, 1e-12);
}

// Parts of a twentieth of a radian are the circle to a millionth of a per mille.
TEST(SetPointPath, MeasuresDistanceFromCircle) {
    constexpr double kRadius_mm = 50, kStep_rad = 0.05;
    SetPointPath path;
    path.begin({kRadius_mm, 0, 0});
    const auto end = [&](double phi) {
        return SetPointPath::EndPoint{kRadius_mm * Vector3d(std::cos(phi), std::sin(phi), 0),
                                      kStep_rad * kRadius_mm * Vector3d(-std::sin(phi), std::cos(phi), 0)};
    };
    for (int i = 0; i < 60; ++i) path.add_curve(end(i * kStep_rad), end((i + 1) * kStep_rad), i);
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
        const double phi = std::uniform_real_distribution<double>(0.05, 2.95)(random);
        const double off = std::uniform_real_distribution<double>(-20, 20)(random);
        const Vector3d point = (kRadius_mm + off) * Vector3d(std::cos(phi), std::sin(phi), 0);
        EXPECT_NEAR(path.distance_mm(point), std::abs(off), 1e-6);
    }
}

// The nearest part is found for any order of the search, compared with a check of points on all of them.
TEST(SetPointPath, RandomPathsMatchSampledPoints) {
    std::mt19937 random(11);
    const auto any = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
    for (int round = 0; round < 50; ++round) {
        SetPointPath path;
        Vector3d at(any(1), any(1), any(1));
        path.begin(at);
        std::vector<Vector3d> points{at};
        for (int i = 0; i < 40; ++i) {
            const Vector3d to = at + Vector3d(any(3), any(3), any(1));
            path.add_line(to, i, false);
            for (int k = 1; k <= 1000; ++k) points.push_back(at + k / 1000.0 * (to - at));
            at = to;
        }
        for (int i = 0; i < 20; ++i) {
            const Vector3d point(any(8), any(8), any(3));
            double min = 1e9;
            for (const Vector3d& other : points) min = std::min(min, (other - point).norm());
            EXPECT_NEAR(path.distance_mm(point), min, 1e-3);
            EXPECT_LE(path.distance_mm(point), min + 1e-12);
        }
    }
}

}  // namespace
}  // namespace gsim::simulation
