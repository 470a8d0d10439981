#include "analysis/envelope/surface.h"

#include <unordered_map>
#include <utility>

namespace gsim::envelope {

namespace {

using Tetrahedron = std::array<Eigen::Array3i, 4>;

// Returns tetrahedra from one corner of a cube to the opposite one along its edges, in all orders of the
// three directions. Corners are ordered so that their determinant is positive.
std::array<Tetrahedron, 6> tetrahedra() {
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};  // three even ones, three odd
    std::array<Tetrahedron, 6> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Eigen::Array3i corner(0, 0, 0);
        for (std::size_t k = 0; k < 4; ++k) {
            all[i][k] = corner;
            if (k < 3) corner[kOrders[i][k]] += 1;
        }
        if (i >= 3) std::swap(all[i][1], all[i][2]);
    }
    return all;
}

class Builder {
  public:
    Builder(const DistanceGrid& grid, double iso_level_mm)
        : grid_(grid), level_mm_(iso_level_mm), tetrahedra_(tetrahedra()) {}

    Surface build() {
        for (int z = 0; z + 1 < grid_.count.z(); ++z) {
            for (int y = 0; y + 1 < grid_.count.y(); ++y) {
                for (int x = 0; x + 1 < grid_.count.x(); ++x) add_cube({x, y, z});
            }
        }
        return std::move(surface_);
    }

  private:
    struct Node {
        std::size_t index;
        Eigen::Array3i position;
    };
    using Nodes = std::array<Node, 4>;

    bool is_inside(std::size_t node) const { return grid_.distance_mm[node] <= level_mm_; }

    bool is_crossed(const Eigen::Array3i& cube) const {
        const bool first = is_inside(grid_.index(cube.x(), cube.y(), cube.z()));
        for (int i = 1; i < 8; ++i) {
            if (is_inside(grid_.index(cube.x() + (i & 1), cube.y() + (i >> 1 & 1), cube.z() + (i >> 2))) !=
                first)
                return true;
        }
        return false;
    }

    void add_cube(const Eigen::Array3i& cube) {
        if (!is_crossed(cube)) return;
        for (const Tetrahedron& corners : tetrahedra_) {
            Nodes nodes;
            for (std::size_t i = 0; i < 4; ++i) {
                const Eigen::Array3i position = cube + corners[i];
                nodes[i] = {grid_.index(position.x(), position.y(), position.z()), position};
            }
            add_tetrahedron(nodes);
        }
    }

    // Reorders the corners in the same sense, those inside first or the odd one out first.
    void add_tetrahedron(const Nodes& nodes) {
        constexpr std::array<std::array<std::size_t, 4>, 4> kOneCornerInside{
            {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};
        constexpr std::array<std::array<std::size_t, 4>, 6> kTwoCornersInside{
            {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
        const auto inside = [&](std::size_t i) { return is_inside(nodes[i].index); };
        const int count = int{inside(0)} + int{inside(1)} + int{inside(2)} + int{inside(3)};
        if (count == 1 || count == 3) {
            for (const auto& [a, b, c, d] : kOneCornerInside) {
                if (inside(a) != (count == 1)) continue;
                const auto ab = cut(nodes[a], nodes[b]);
                const auto ac = cut(nodes[a], nodes[c]);
                const auto ad = cut(nodes[a], nodes[d]);
                if (count == 1) {
                    surface_.triangles.push_back({ab, ac, ad});
                } else {
                    surface_.triangles.push_back({ab, ad, ac});
                }
            }
        } else if (count == 2) {
            for (const auto& [a, b, c, d] : kTwoCornersInside) {
                if (!inside(a) || !inside(b)) continue;
                const auto ac = cut(nodes[a], nodes[c]);
                const auto ad = cut(nodes[a], nodes[d]);
                const auto bd = cut(nodes[b], nodes[d]);
                const auto bc = cut(nodes[b], nodes[c]);
                surface_.triangles.push_back({ac, ad, bd});
                surface_.triangles.push_back({ac, bd, bc});
            }
        }
    }

    // Returns the point where the edge between two nodes passes the level; the same point for all callers.
    std::uint32_t cut(const Node& a, const Node& b) {
        if (a.index > b.index) return cut(b, a);
        const std::uint64_t edge = (static_cast<std::uint64_t>(a.index) << 32U) | b.index;
        const auto [found, is_new] =
            points_.try_emplace(edge, static_cast<std::uint32_t>(surface_.points_mm.size()));
        if (is_new) {
            const double from = grid_.distance_mm[a.index];
            const double share = (level_mm_ - from) / (grid_.distance_mm[b.index] - from);
            const Vector3d start = grid_.node(a.position);
            surface_.points_mm.emplace_back(start + share * (grid_.node(b.position) - start));
        }
        return found->second;
    }

    const DistanceGrid& grid_;
    double level_mm_;
    std::array<Tetrahedron, 6> tetrahedra_;
    std::unordered_map<std::uint64_t, std::uint32_t> points_;
    Surface surface_;
};

}  // namespace

Surface extract_isosurface(const DistanceGrid& grid, double iso_level_mm) {
    return Builder(grid, iso_level_mm).build();
}

double volume_mm3(const Surface& surface) {
    double volume_times_six = 0;
    for (const auto& [a, b, c] : surface.triangles)
        volume_times_six += surface.points_mm[a].dot(surface.points_mm[b].cross(surface.points_mm[c]));
    return volume_times_six / 6;
}

}  // namespace gsim::envelope
