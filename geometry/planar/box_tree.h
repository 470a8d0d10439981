#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/planar/point.h"

namespace gsim::geometry {

/// Search for those of many boxes, of any size, that meet a given one: a packed R-tree, its leaves in the
/// order of a space-filling curve (Kamel and Faloutsos, "On packing R-trees", 1993). Building takes O(n log
/// n).
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Box> boxes);

    /// Calls visit(index) for each box that meets `range`, until it returns false.
    template <typename Visit>
    void visit(const Box& range, Visit&& visit) const;

  private:
    static constexpr std::size_t kFanOut = 8;
    static constexpr std::size_t kMaxStack = 512;  // fan-out times the levels of 2^64 boxes

    struct Level {
        std::size_t first, count;  // in nodes_
    };
    struct TreePosition {
        std::size_t level, node;
    };

    std::vector<Box> nodes_;  // leaves first, the root last
    std::vector<Level> levels_;
    std::vector<std::uint32_t> leaf_items_;  // indices into the boxes given
};

template <typename Visit>
void BoxTree::visit(const Box& range, Visit&& visit) const {
    if (levels_.empty()) return;
    TreePosition stack[kMaxStack];
    std::size_t depth = 0;
    stack[depth++] = {levels_.size() - 1, 0};
    while (depth > 0) {
        const TreePosition node_position = stack[--depth];
        if (!nodes_[levels_[node_position.level].first + node_position.node].overlaps(range)) continue;
        if (node_position.level == 0) {
            if (!visit(static_cast<std::size_t>(leaf_items_[node_position.node]))) return;
            continue;
        }
        const std::size_t first = node_position.node * kFanOut;
        const std::size_t last = std::min(first + kFanOut, levels_[node_position.level - 1].count);
        for (std::size_t child = first; child < last; ++child)
            stack[depth++] = {node_position.level - 1, child};
    }
}

}  // namespace gsim::geometry
