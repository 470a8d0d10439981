#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "cam/surface/jet_path.h"
#include "cam/surface/wall_alignment.h"

namespace gsim::surface::twisted_wall_test {

namespace {

constexpr JetShape kJet{0.8, 0};
constexpr double kDepth_mm = 6;
constexpr double kTiny = 1e-5;

using Curve = std::function<Vector(double)>;

solid::Vec3 to_vec3(const Vector& v) {
    return {v.x(), v.y(), v.z()};
}

Vector slope(const Curve& curve, double at) {
    return (curve(at + kTiny) - curve(at - kTiny)).normalized();
}

// Returns the wall from one curve to another one below it, by straight lines between the same parameters.
// Material is to the left of the path from 0 to 1.
solid::WallEdge wall(const std::string& name, const Curve& upper, const Curve& lower) {
    constexpr int kSteps = 400;
    const Vector up(0, 0, 1);
    solid::WallEdge edge{name, {}, 0};
    for (int i = 0; i <= kSteps; ++i) {
        const double at = static_cast<double>(i) / kSteps;
        const Vector down = lower(at) - upper(at);
        solid::WallPoint point;
        point.position_mm = to_vec3(upper(at));
        point.normal = to_vec3(up);
        point.tangent = to_vec3(slope(upper, at));
        point.along_wall = to_vec3(down.normalized());
        point.depth_mm = down.norm();
        point.wall_normal = to_vec3(down.cross(slope(upper, at)).normalized());
        point.exit_normal = to_vec3(down.cross(slope(lower, at)).normalized());
        edge.points.push_back(point);
    }
    return edge;
}

JetPath jet_path_of(const std::vector<solid::WallEdge>& edges) {
    const solid::WallContour contour{"the plane face #1", true, edges};
    auto path = jet_path(contour, kJet, {});
    EXPECT_TRUE(path) << path.error().message;
    return path ? *path : JetPath{};
}

// Returns the smallest and the largest deviation of the cut from a curve.
std::pair<double, double> off(const Curve& curve, const JetPath& jet_path) {
    double min = std::numeric_limits<double>::infinity();
    double max = -min;
    for (int i = 0; i < 250; ++i) {
        const Vector position = curve(i / 250.0);
        double nearest = std::numeric_limits<double>::infinity();
        for (const JetPoint& at : jet_path.points)
            nearest = std::min(nearest, (position - jet_center(at, kJet)).cross(at.axis).norm());
        min = std::min(min, nearest - kJet.kerf_mm / 2);
        max = std::max(max, nearest - kJet.kerf_mm / 2);
    }
    return {min, max};
}

// Round a circle clockwise, so that what is around it is to the left.
Vector around(double radius_mm, double share, double z_mm) {
    const double turn = -2 * std::numbers::pi * share;
    return {radius_mm * std::cos(turn), radius_mm * std::sin(turn), z_mm};
}

Curve line(const Vector& from, const Vector& to) {
    return [=](double share) -> Vector { return from + share * (to - from); };
}

}  // namespace

TEST(TwistedWall, CutsBothCirclesOfHyperboloid) {
    // The lower circle is larger, and each line of the wall advances by 40 degrees: its normals differ by 35
    // deg.
    const Curve upper = [](double share) { return around(10, share, 0); };
    const Curve lower = [](double share) { return around(12, share + 40.0 / 360, -kDepth_mm); };
    const JetPath jet_path = jet_path_of({wall("edge #1", upper, lower)});
    for (const Curve& each : {upper, lower}) {
        const auto [min, max] = off(each, jet_path);
        EXPECT_GT(min, -0.002);
        EXPECT_LT(max, 0.005);
    }
    EXPECT_TRUE(jet_path.lower_corners.empty());
}

TEST(TwistedWall, JetTurnsAtLowerCornersOrReportsUncutMaterial) {
    // A square hole; the wall below the upper half of its right side leans more and more, so that the lower
    // edge has a corner in its middle, into the hole or out of it.
    for (const double lean_mm : {-4.0, 4.0}) {
        const Vector down(0, 0, -kDepth_mm);
        const Vector a(10, -10, 0), middle(10, 0, 0), b(10, 10, 0), c(-10, 10, 0), d(-10, -10, 0);
        const Vector off_b = b + down + Vector(lean_mm, 0, 0);
        // Clockwise: up the left side, to the right, down the right side.
        const JetPath jet_path = jet_path_of({wall("edge #1", line(d, c), line(d + down, c + down)),
                                              wall("edge #2", line(c, b), line(c + down, off_b)),
                                              wall("edge #3", line(b, middle), line(off_b, middle + down)),
                                              wall("edge #4", line(middle, a), line(middle + down, a + down)),
                                              wall("edge #5", line(a, d), line(a + down, d + down))});
        const double turn_rad = std::atan(std::abs(lean_mm) / 10);
        const auto [min, max] = off(line(middle + down, a + down), jet_path);
        EXPECT_GT(min, -kAllowedGouge_mm) << lean_mm;
        const auto [least_beside, greatest_beside] = off(line(off_b, middle + down), jet_path);
        EXPECT_GT(least_beside, -kAllowedGouge_mm) << lean_mm;
        const auto found = std::find_if(
            jet_path.lower_corners.begin(), jet_path.lower_corners.end(),
            [&](const LowerCorner& each) { return (each.lower_edge_mm - (middle + down)).norm() < 1e-9; });
        if (lean_mm > 0) {
            // The hole is wider there: material comes to a point, about which the jet turns.
            EXPECT_EQ(found, jet_path.lower_corners.end());
            EXPECT_LT(std::max(max, greatest_beside), 0.35);  // at the corners of the square alone
            continue;
        }
        ASSERT_NE(found, jet_path.lower_corners.end());
        const LowerCorner& corner = *found;
        EXPECT_NEAR(corner.turn_deg, turn_rad * 180 / std::numbers::pi, 2);
        // A circle in the corner between two lines is off its point by as much.
        const double is_fixed = kJet.kerf_mm / 2 * (1 / std::cos(turn_rad / 2) - 1);
        EXPECT_NEAR(corner.uncut_mm, is_fixed, 0.2 * is_fixed + 0.002);
    }
}

}  // namespace gsim::surface::twisted_wall_test
