#include "geometry/planar/box_tree.h"

#include <numeric>

namespace gsim::geometry {

namespace {

// Returns the bits of x spread apart, with a zero bit between neighbours.
std::uint64_t interleave_zeros(std::uint64_t x) {
    x = (x | x << 16) & 0x0000ffff0000ffffULL;
    x = (x | x << 8) & 0x00ff00ff00ff00ffULL;
    x = (x | x << 4) & 0x0f0f0f0f0f0f0f0fULL;
    x = (x | x << 2) & 0x3333333333333333ULL;
    return (x | x << 1) & 0x5555555555555555ULL;
}

std::uint64_t cell(double value, double low, double high) {
    constexpr double kCellsPerAxis = 4294967295.0;
    const double share = high > low ? (value - low) / (high - low) : 0;
    return static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * kCellsPerAxis);
}

// Returns the position of the middle of a box on the Z-curve through `all`.
std::uint64_t morton_code(const Box& box, const Box& all) {
    const Point middle = 0.5 * (box.low + box.high);
    return interleave_zeros(cell(middle.x, all.low.x, all.high.x)) |
           interleave_zeros(cell(middle.y, all.low.y, all.high.y)) << 1;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
    if (boxes.empty()) return;
    Box all;
    for (const Box& box : boxes) all.add(box);
    std::vector<std::uint64_t> curve_indices;
    curve_indices.reserve(boxes.size());
    for (const Box& box : boxes) curve_indices.push_back(morton_code(box, all));
    leaf_items_.resize(boxes.size());
    std::iota(leaf_items_.begin(), leaf_items_.end(), 0U);
    std::sort(leaf_items_.begin(), leaf_items_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return curve_indices[a] != curve_indices[b] ? curve_indices[a] < curve_indices[b] : a < b;
    });
    nodes_.reserve(boxes.size() + boxes.size() / (kFanOut - 1) + kFanOut);
    for (const std::uint32_t item : leaf_items_) nodes_.push_back(boxes[item]);
    levels_.push_back({0, boxes.size()});
    while (levels_.back().count > 1) {
        const Level below = levels_.back();
        const Level level{nodes_.size(), (below.count + kFanOut - 1) / kFanOut};
        for (std::size_t i = 0; i < level.count; ++i) {
            Box box;
            const std::size_t last = std::min((i + 1) * kFanOut, below.count);
            for (std::size_t child = i * kFanOut; child < last; ++child) box.add(nodes_[below.first + child]);
            nodes_.push_back(box);
        }
        levels_.push_back(level);
    }
}

}  // namespace gsim::geometry
