#include "runtime/cell/triangle_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fcl/geometry/bvh/BVH_model.h>

namespace gsim::cell {

using Eigen::Vector3d;

namespace {

using Tree = fcl::BVHModel<fcl::OBBd>;

void check(std::span<const Vector3d> vertices, std::span<const Triangle> triangles) {
    if (triangles.empty()) throw std::invalid_argument("a mesh needs a triangle");
    const auto finite = [](const Vector3d& v) { return v.allFinite(); };
    if (!std::all_of(vertices.begin(), vertices.end(), finite))
        throw std::invalid_argument("a vertex of a mesh is not finite");
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t corner : triangle) {
            if (corner >= vertices.size()) throw std::invalid_argument("a triangle has no such vertex");
        }
    }
}

// Halves of equally many triangles, so that no mesh makes a deep tree.
void build(Tree& tree, const std::vector<Vector3d>& vertices, std::span<const Triangle> triangles) {
    std::vector<fcl::Triangle> corners;
    corners.reserve(triangles.size());
    for (const Triangle& t : triangles) corners.emplace_back(t[0], t[1], t[2]);
    tree.bv_splitter = std::make_shared<fcl::detail::BVSplitter<fcl::OBBd>>(fcl::detail::SPLIT_METHOD_MEDIAN);
    tree.beginModel(static_cast<int>(corners.size()), static_cast<int>(vertices.size()));
    tree.addSubModel(vertices, corners);
    if (tree.endModel() != fcl::BVH_OK) throw std::invalid_argument("no tree can be made of a mesh");
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vector3d> vertices_mm, std::span<const Triangle> triangles)
    : vertices_mm_(std::move(vertices_mm)), triangle_count_(triangles.size()) {
    check(vertices_mm_, triangles);
    Tree tree;
    build(tree, vertices_mm_, triangles);
    nodes_.resize(static_cast<std::size_t>(tree.getNumBVs()));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const auto& from = tree.getBV(static_cast<int>(i));
        Node& node = nodes_[i];
        node.box.core = Convex::Core::box;
        node.box.half_mm = from.bv.extent;
        node.pose = Eigen::Isometry3d::Identity();
        node.pose.linear() = from.bv.axis;
        node.pose.translation() = from.bv.To;
        if (!from.isLeaf()) {
            node.first_child = from.leftChild();
            continue;
        }
        const Triangle& corners = triangles[static_cast<std::size_t>(from.primitiveId())];
        node.triangle.point_count = 3;
        for (std::size_t c = 0; c < 3; ++c) node.triangle.points[c] = vertices_mm_[corners[c]];
    }
}

}  // namespace gsim::cell
