#include <algorithm>

#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include "geometry/distance/shape.h"
#include "tests/collision/meshes.h"

namespace gsim::cell::shape_gap_test {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kUnbounded_mm = 1e6;

Isometry3d turned(double angle_deg, const Vector3d& axis, const Isometry3d& pose) {
    return pose * Isometry3d(Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis));
}

void expect_gap(const Gap& gap, double distance_mm, double within_mm = 1e-8) {
    EXPECT_NEAR(gap.upper_mm, distance_mm, within_mm);
    EXPECT_NEAR(gap.lower_mm, distance_mm, within_mm);
    EXPECT_NEAR((gap.on_first - gap.on_second).norm(), distance_mm, within_mm);
}

TEST(ShapeGap, MeasuresBoxesAtFacesEdgesAndCorners) {
    const Shape box = Shape::box({10, 20, 30});
    expect_gap(shape_distance(box, shift(13, 5, 5), box, kUnbounded_mm), 3);
    expect_gap(shape_distance(box, shift(13, 24, 0), box, kUnbounded_mm), 5);
    expect_gap(shape_distance(box, shift(12, 23, 36), box, kUnbounded_mm), 7);
    const Shape cube = Shape::box({10, 10, 10});
    expect_gap(shape_distance(cube, turned(45, Vector3d::UnitZ(), shift(20, 0, 0)), cube, kUnbounded_mm),
               15 - 5 * std::sqrt(2.0));
}

TEST(ShapeGap, MeasuresRoundBodiesAbovePlate) {
    const Shape plate = Shape::box({200, 200, 2});
    expect_gap(shape_distance(Shape::sphere(10), shift(3, 4, 8), plate, kUnbounded_mm), 2);
    expect_gap(shape_distance(Shape::capsule(10, 20), shift(3, 4, 18), plate, kUnbounded_mm), 2);
    expect_gap(shape_distance(Shape::cylinder(10, 20), shift(3, 4, 13), plate, kUnbounded_mm), 2);
    const auto lying = turned(90, Vector3d::UnitX(), shift(3, 4, 8));
    expect_gap(shape_distance(Shape::cylinder(10, 20), lying, plate, kUnbounded_mm), 2);
    // Tilted by 30 degrees the cylinder's rim is lowest.
    const auto tilted = turned(30, Vector3d::UnitY(), shift(0, 0, 20));
    const double low = 10 * std::cos(std::numbers::pi / 6) + 5 * std::sin(std::numbers::pi / 6);
    expect_gap(shape_distance(Shape::cylinder(10, 20), tilted, plate, kUnbounded_mm), 19 - low);
}

TEST(ShapeGap, MeasuresRoundBodiesSideBySide) {
    const auto across = turned(90, Vector3d::UnitX(), shift(0, 0, 20));
    expect_gap(shape_distance(Shape::cylinder(10, 50), across, Shape::sphere(6), kUnbounded_mm), 12);
    expect_gap(
        shape_distance(Shape::cylinder(10, 50), shift(30, 40, 0), Shape::cylinder(20, 50), kUnbounded_mm),
        35);
    expect_gap(
        shape_distance(Shape::cylinder(10, 50), shift(30, 40, 62), Shape::cylinder(20, 50), kUnbounded_mm),
        std::hypot(35, 12));
}

TEST(ShapeGap, IsZeroForOverlap) {
    const Shape box = Shape::box({10, 10, 10});
    EXPECT_EQ(shape_distance(box, shift(3, 3, 3), box, kUnbounded_mm).upper_mm, 0);
    EXPECT_EQ(shape_distance(box, Isometry3d::Identity(), box, kUnbounded_mm).upper_mm, 0);
    EXPECT_EQ(shape_distance(Shape::sphere(8), shift(8, 0, 0), box, kUnbounded_mm).upper_mm, 0);
    EXPECT_EQ(shape_distance(Shape::cylinder(8, 8), shift(8, 0, 0), box, kUnbounded_mm).upper_mm, 0);
}

TEST(ShapeGap, CapsLowerBoundAtLimit) {
    const Shape box = Shape::box({10, 10, 10});
    EXPECT_EQ(shape_distance(box, shift(100, 0, 0), box, 50).lower_mm, 50);
}

// A distance is proved from both sides: two points of the bodies are as near, and a plane between them keeps
// the bodies as far from each other.
TEST(ShapeGap, BoundsOfRandomConvexBodiesAgree) {
    std::mt19937 random(3);
    for (int i = 0; i < 3000; ++i) {
        const double diameter = between(random, 0.1, 100);
        const double height = between(random, 0.1, 100);
        const Isometry3d pose = random_pose(random, 120);
        const Vector3d size = Vector3d::Constant(51) + random_vector(random, 50);
        const Gap gap =
            shape_distance(Shape::cylinder(diameter, height), pose, Shape::box(size), kUnbounded_mm);
        EXPECT_LE(gap.upper_mm - gap.lower_mm, 1e-6);
        if (gap.upper_mm == 0) continue;
        const Vector3d in_cylinder = pose.inverse() * gap.on_first;
        EXPECT_LE(std::hypot(in_cylinder.x(), in_cylinder.y()), diameter / 2 + 1e-9);
        EXPECT_LE(std::abs(in_cylinder.z()), height / 2 + 1e-9);
        EXPECT_LE((gap.on_second.cwiseAbs() - size / 2).maxCoeff(), 1e-9);
    }
}

// A body moved by 1e-7 mm is nearer or farther by no more: no flat set of corners counts as an overlap.
TEST(ShapeGap, ChangesContinuously) {
    std::mt19937 random(17);
    const Isometry3d current = Isometry3d::Identity();
    for (int i = 0; i < 20'000; ++i) {
        const Shape tool = Shape::cylinder(between(random, 0.1, 50), between(random, 0.1, 50));
        Convex triangle;
        triangle.point_count = 3;
        for (Vector3d& point : triangle.points) point = random_vector(random, 40);
        const Isometry3d pose = random_pose(random, 30);
        Isometry3d shifted = pose;
        shifted.translation() += 1e-7 * random_vector(random, 1).normalized();
        const Gap gap = shape_distance({*tool.convex(), pose, pose}, triangle, current, {kUnbounded_mm});
        const Gap moved =
            shape_distance({*tool.convex(), shifted, shifted}, triangle, current, {kUnbounded_mm});
        EXPECT_NEAR(gap.upper_mm, moved.upper_mm, 1e-4);
        EXPECT_NEAR(gap.lower_mm, gap.upper_mm, 1e-4);
    }
}

// Bodies that the library of collisions treats by another algorithm.
TEST(ShapeGap, AgreesWithFclForBoxes) {
    std::mt19937 random(4);
    for (int i = 0; i < 500; ++i) {
        const Isometry3d pose = random_pose(random, 150);
        const Vector3d a = Vector3d::Constant(51) + random_vector(random, 50);
        const Vector3d b = Vector3d::Constant(51) + random_vector(random, 50);
        const fcl::CollisionObjectd first(std::make_shared<fcl::Boxd>(a), pose);
        const fcl::CollisionObjectd second(std::make_shared<fcl::Boxd>(b));
        fcl::DistanceResultd result;
        const double expected =
            std::max(0.0, fcl::distance(&first, &second, fcl::DistanceRequestd(), result));
        EXPECT_NEAR(shape_distance(Shape::box(a), pose, Shape::box(b), kUnbounded_mm).upper_mm, expected,
                    1e-4);
    }
}

TEST(ShapeGap, MeshDistanceIsThatOfNearestTriangle) {
    std::mt19937 random(5);
    const Surface surface = torus(100, 30, 16);
    const Shape mesh = Shape::mesh(surface.mesh());
    const Isometry3d current = Isometry3d::Identity();
    for (int i = 0; i < 60; ++i) {
        const Isometry3d pose = random_pose(random, 150);
        double expected = kUnbounded_mm;
        for (const Triangle& corners : surface.triangles) {
            Convex triangle;
            triangle.point_count = 3;
            for (std::size_t c = 0; c < 3; ++c) triangle.points[c] = surface.vertices[corners[c]];
            const Convex ball = *Shape::sphere(10).convex();
            expected = std::min(
                expected, shape_distance({ball, pose, pose}, triangle, current, {kUnbounded_mm}).upper_mm);
        }
        EXPECT_NEAR(shape_distance(Shape::sphere(10), pose, mesh, kUnbounded_mm).upper_mm, expected, 1e-8);
        EXPECT_NEAR(shape_distance(mesh, pose.inverse(), Shape::sphere(10), kUnbounded_mm).upper_mm, expected,
                    1e-8);
    }
}

TEST(ShapeGap, MeshOfBoxEqualsBox) {
    std::mt19937 random(6);
    const Shape box = Shape::box({20, 30, 40});
    const Shape mesh = Shape::mesh(box_surface({20, 30, 40}).mesh());
    const Shape other = Shape::mesh(box_surface({10, 50, 5}).mesh());
    for (int i = 0; i < 100; ++i) {
        const Isometry3d pose = random_pose(random, 80);
        const double expected = shape_distance(Shape::box({10, 50, 5}), pose, box, kUnbounded_mm).upper_mm;
        if (expected == 0) continue;
        EXPECT_NEAR(shape_distance(other, pose, mesh, kUnbounded_mm).upper_mm, expected, 1e-8);
    }
}

TEST(ShapeGap, SweptHullHasMinDistanceOfStraightPath) {
    std::mt19937 random(7);
    const Shape mesh = Shape::mesh(torus(60, 20, 12).mesh());
    const Shape tool = Shape::cylinder(15, 40);
    for (int i = 0; i < 20; ++i) {
        const Isometry3d from = random_pose(random, 120);
        const Vector3d displacement = random_vector(random, 60);
        Isometry3d to = from;
        to.translation() += displacement;
        double nearest = kUnbounded_mm;
        for (int step = 0; step <= 200; ++step) {
            Isometry3d at = from;
            at.translation() += displacement * step / 200;
            nearest = std::min(nearest, shape_distance(tool, at, mesh, kUnbounded_mm).upper_mm);
        }
        const Gap swept_gap = shape_distance(tool, from, to, mesh, kUnbounded_mm);
        EXPECT_LE(swept_gap.upper_mm, nearest + 1e-9);
        EXPECT_GE(swept_gap.upper_mm, nearest - displacement.norm() / 200);
        EXPECT_NEAR(swept_gap.lower_mm, swept_gap.upper_mm, 1e-6);
    }
}

TEST(TriangleMesh, RejectsInvalidMesh) {
    const std::vector<Vector3d> corners{Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY()};
    EXPECT_THROW(TriangleMesh(corners, {}), std::invalid_argument);
    EXPECT_THROW(TriangleMesh(corners, std::vector<Triangle>{{0, 1, 3}}), std::invalid_argument);
    const std::vector<Vector3d> infinite{Vector3d::Zero(), Vector3d::UnitX(), Vector3d(0, 0, INFINITY)};
    EXPECT_THROW(TriangleMesh(infinite, std::vector<Triangle>{{0, 1, 2}}), std::invalid_argument);
}

TEST(TriangleMesh, KeepsTrianglesWithoutArea) {
    const std::vector<Vector3d> corners{Vector3d::Zero(), Vector3d::UnitX(), Vector3d(2, 0, 0)};
    const std::vector<Triangle> triangles(40, Triangle{0, 1, 2});
    const Shape needle = Shape::mesh(std::make_shared<const TriangleMesh>(corners, triangles));
    expect_gap(shape_distance(Shape::sphere(2), shift(1.5, 3, 4), needle, kUnbounded_mm), 4);
    const Shape point =
        Shape::mesh(std::make_shared<const TriangleMesh>(corners, std::vector<Triangle>{{0, 0, 0}}));
    expect_gap(shape_distance(Shape::sphere(2), shift(0, 3, 4), point, kUnbounded_mm), 4);
}

}  // namespace
}  // namespace gsim::cell::shape_gap_test
