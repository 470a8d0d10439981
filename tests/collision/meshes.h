#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/distance/triangle_mesh.h"

namespace gsim::cell {

/// Surfaces to test with.
struct Surface {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Triangle> triangles;

    std::shared_ptr<const TriangleMesh> mesh() const {
        return std::make_shared<const TriangleMesh>(vertices, triangles);
    }
};

/// A torus about Z of 2 n^2 triangles.
inline Surface torus(double major_radius_mm, double minor_radius_mm, int n) {
    Surface surface;
    const auto index = [n](int i, int j) { return static_cast<std::uint32_t>((i % n) * n + j % n); };
    const double step = 2 * std::numbers::pi / n;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double out = major_radius_mm + minor_radius_mm * std::cos(j * step);
            surface.vertices.emplace_back(out * std::cos(i * step), out * std::sin(i * step),
                                          minor_radius_mm * std::sin(j * step));
            surface.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            surface.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    }
    return surface;
}

/// The twelve triangles of a box about the origin.
inline Surface box_surface(const Eigen::Vector3d& size_mm) {
    Surface surface;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
        surface.vertices.emplace_back(corner.cwiseProduct(size_mm));
    }
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
}

inline double between(std::mt19937& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

inline Eigen::Vector3d random_vector(std::mt19937& random, double max) {
    const double x = between(random, -max, max);
    const double y = between(random, -max, max);
    return {x, y, between(random, -max, max)};
}

inline Eigen::Isometry3d shift(double x, double y, double z) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

inline Eigen::Isometry3d random_pose(std::mt19937& random, double max_mm) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = random_vector(random, max_mm);
    const double angle = between(random, -std::numbers::pi, std::numbers::pi);
    pose.rotate(Eigen::AngleAxisd(angle, random_vector(random, 1).normalized()));
    return pose;
}

}  // namespace gsim::cell
