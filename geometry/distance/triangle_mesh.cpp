#include "geometry/distance/triangle_mesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace gsim::cell {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

void check(std::span<const Vector3d> vertices, std::span<const Triangle> triangles) {
    if (triangles.empty()) throw std::invalid_argument("a mesh must have at least one triangle");
    const auto is_finite = [](const Vector3d& v) { return v.allFinite(); };
    if (!std::all_of(vertices.begin(), vertices.end(), is_finite))
        throw std::invalid_argument("a vertex of a mesh is not finite");
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t corner : triangle) {
            if (corner >= vertices.size())
                throw std::invalid_argument("a triangle refers to a vertex that does not exist");
        }
    }
}

/// Builder of the tree of boxes along the main axes of their content (Gottschalk, Lin, Manocha: OBBTree,
/// SIGGRAPH 1996). Each box is split into halves with equally many triangles, so that no mesh makes a deep
/// tree. The same mesh makes the same tree with every compiler and library, because sums and halves have one
/// order.
class TreeBuilder {
  public:
    using Node = TriangleMesh::Node;

    TreeBuilder(std::span<const Vector3d> vertices, std::span<const Triangle> triangles,
                std::vector<Node>& nodes)
        : vertices_(vertices), triangles_(triangles), nodes_(nodes), order_(triangles.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
    }

    void build() {
        nodes_.reserve(2 * triangles_.size() - 1);
        nodes_.emplace_back();
        fill(0, order_);
    }

  private:
    using Part = std::span<std::uint32_t>;
    using AxisPosition = std::pair<double, std::uint32_t>;  // position of a triangle, and its index

    template <typename Visitor>
    void for_each_corner(Part part, const Visitor& visit) const {
        for (const std::uint32_t triangle : part) {
            for (const std::uint32_t corner : triangles_[triangle]) visit(vertices_[corner]);
        }
    }

    /// Returns the main axes of the corners of a part, that of the largest extent last.
    Matrix3d axes_of(Part part) const {
        Vector3d sum = Vector3d::Zero();
        for_each_corner(part, [&](const Vector3d& corner) { sum += corner; });
        const Vector3d mean = sum / static_cast<double>(3 * part.size());
        Matrix3d scatter = Matrix3d::Zero();
        for_each_corner(
            part, [&](const Vector3d& corner) { scatter += (corner - mean) * (corner - mean).transpose(); });
        Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter).eigenvectors();
        if (!axes.allFinite()) return Matrix3d::Identity();  // from values with infinite or NaN squares
        if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
        return axes;
    }

    void set_box(Part part, Node& node) const {
        const Matrix3d axes = axes_of(part);
        Eigen::AlignedBox3d box;
        for_each_corner(part,
                        [&](const Vector3d& corner) { box.extend(Vector3d(axes.transpose() * corner)); });
        node.box.core = Convex::Core::box;
        node.box.half_mm = box.sizes() / 2;
        node.pose = Eigen::Isometry3d::Identity();
        node.pose.linear() = axes;
        node.pose.translation() = axes * box.center();
    }

    void fill(std::size_t index, Part part) {
        set_box(part, nodes_[index]);
        if (part.size() == 1) return set_triangle(part.front(), nodes_[index]);
        Eigen::Index widest = 0;
        nodes_[index].box.half_mm.maxCoeff(&widest);
        halve(nodes_[index].pose.linear().col(widest), part);
        const std::size_t half = part.size() / 2;
        const std::size_t first_child = nodes_.size();
        nodes_[index].first_child = static_cast<int>(first_child);
        nodes_.resize(first_child + 2);
        fill(first_child, part.first(half));
        fill(first_child + 1, part.subspan(half));
    }

    /// Splits a part: the half that is lower along an axis comes first; in each the triangles stay in their
    /// order.
    void halve(const Vector3d& axis, Part part) {
        std::vector<AxisPosition> positions;
        positions.reserve(part.size());
        for (const std::uint32_t triangle : part)
            positions.push_back({axis_coordinate(axis, triangles_[triangle]), triangle});
        std::vector<AxisPosition> sorted = positions;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        const AxisPosition upper_half_begin = *middle;
        std::stable_partition(positions.begin(), positions.end(),
                              [&](const AxisPosition& a) { return a < upper_half_begin; });
        std::transform(positions.begin(), positions.end(), part.begin(),
                       [](const AxisPosition& a) { return a.second; });
    }

    double axis_coordinate(const Vector3d& axis, const Triangle& corners) const {
        double sum = 0;
        for (const std::uint32_t corner : corners) sum += axis.dot(vertices_[corner]);
        return std::isfinite(sum) ? sum : 0;
    }

    void set_triangle(std::uint32_t triangle, Node& node) const {
        node.triangle.point_count = 3;
        for (std::size_t c = 0; c < 3; ++c) node.triangle.points[c] = vertices_[triangles_[triangle][c]];
    }

    std::span<const Vector3d> vertices_;
    std::span<const Triangle> triangles_;
    std::vector<Node>& nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vector3d> vertices_mm, std::span<const Triangle> triangles)
    : vertices_mm_(std::move(vertices_mm)), triangle_count_(triangles.size()) {
    check(vertices_mm_, triangles);
    TreeBuilder(vertices_mm_, triangles, nodes_).build();
}

}  // namespace gsim::cell
