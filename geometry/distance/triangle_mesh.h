#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/distance/convex.h"

namespace gsim::cell {

/// The corners of a triangle, as indices of vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles with a tree of boxes round them, for distances. Immutable.
class TriangleMesh {
  public:
    /// A box of the tree. Its children are at first_child and at the next index; a leaf has a triangle
    /// instead.
    struct Node {
        Convex box;
        Eigen::Isometry3d pose;
        int first_child = -1;
        Convex triangle;

        bool is_leaf() const { return first_child < 0; }
    };

    /// Takes at least one triangle, and indices within `vertices_mm`, which are finite. Throws
    /// std::invalid_argument.
    TriangleMesh(std::vector<Eigen::Vector3d> vertices_mm, std::span<const Triangle> triangles);

    std::span<const Eigen::Vector3d> vertices_mm() const { return vertices_mm_; }
    std::size_t triangle_count() const { return triangle_count_; }
    /// Returns the tree; the first node is its root.
    std::span<const Node> nodes() const { return nodes_; }

  private:
    std::vector<Eigen::Vector3d> vertices_mm_;
    std::size_t triangle_count_;
    std::vector<Node> nodes_;
};

}  // namespace gsim::cell
