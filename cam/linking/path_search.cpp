#include "cam/linking/path_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace gsim::linking {

namespace {

// Resolution of a node in programs.
constexpr double kGridStep = 1e-3;
// Number of samples in which the search space, starting from the box about both ends, grows by the full axis
// ranges.
constexpr int kGrowthSamples = 60;
constexpr double kInitialMargin = 0.02;
// A branch that is not clear is tried at a half, a quarter, an eighth of its length.
constexpr std::array<double, 4> kShares{1, 0.5, 0.25, 0.125};
constexpr int kShortcutAttempts = 100;
// Number of searches; the fastest path counts.
constexpr std::uint32_t kSearchCount = 6;
// Number of failed searches that end the search.
constexpr std::uint32_t kMaxFailedSearches = 3;
// In all but every third search, an axis of a sample stays at its value of one of the ends with this
// probability: many axes need not move. That finds faster paths, but does not pass all narrow gaps.
constexpr double kKeepProbability = 0.4;

double snap_to_grid(double value) {
    return std::round(value / kGridStep) * kGridStep;
}

AxisValues snap_to_grid(const AxisValues& node) {
    return node.unaryExpr([](double value) { return snap_to_grid(value); });
}

// Random numbers that are the same with any library; the distributions of the standard do not guarantee that.
class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}

    double share() { return static_cast<double>(engine_()) / 4294967296.0; }
    std::size_t random_index(std::size_t count) {
        return static_cast<std::size_t>(share() * static_cast<double>(count));
    }

  private:
    std::mt19937 engine_;
};

class Tree {
  public:
    explicit Tree(AxisValues root) : nodes_{std::move(root)}, parents_{0} {}

    std::size_t nearest(const AxisValues& to, const AxisValues& s_per_unit) const {
        std::size_t best = 0;
        double min = axis_distance_s(nodes_[0], to, s_per_unit);
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            const double s = axis_distance_s(nodes_[i], to, s_per_unit);
            if (s < min) {
                min = s;
                best = i;
            }
        }
        return best;
    }
    const AxisValues& node(std::size_t i) const { return nodes_[i]; }
    std::size_t add(AxisValues node, std::size_t parent) {
        nodes_.push_back(std::move(node));
        parents_.push_back(parent);
        return nodes_.size() - 1;
    }
    /// Returns the nodes from the root to a node, both included.
    AxisPath path_to(std::size_t node) const {
        AxisPath path{nodes_[node]};
        for (; node != 0; node = parents_[node]) path.push_back(nodes_[parents_[node]]);
        std::reverse(path.begin(), path.end());
        return path;
    }

  private:
    static double axis_distance_s(const AxisValues& a, const AxisValues& b, const AxisValues& s_per_unit) {
        return ((a - b).cwiseAbs().cwiseProduct(s_per_unit)).maxCoeff();
    }

    std::vector<AxisValues> nodes_;
    std::vector<std::size_t> parents_;
};

class Search {
  public:
    Search(const SearchSpace& space, const AxisValues& from, const AxisValues& to, int max_queries,
           std::uint32_t seed)
        : space_(space),
          from_(from),
          to_(to),
          remaining_queries_(max_queries),
          keep_probability_(seed % 3 != 0 ? kKeepProbability : 0),
          numbers_(seed) {}

    std::optional<AxisPath> run() {
        std::array<Tree, 2> trees{Tree(from_), Tree(to_)};
        for (int sample = 0; remaining_queries_ > 0; ++sample) {
            const std::size_t tree_index = sample % 2 == 0 ? 0 : 1;
            const auto new_node = grow(trees[tree_index], next_sample(sample));
            if (!new_node) continue;
            const AxisValues meeting_node = trees[tree_index].node(*new_node);
            if (const auto connected_node = connect(trees[1 - tree_index], meeting_node))
                return tree_index == 0 ? joined(trees, *new_node, *connected_node)
                                       : joined(trees, *connected_node, *new_node);
        }
        return std::nullopt;
    }

  private:
    bool is_clear(const AxisValues& from, const AxisValues& to) {
        --remaining_queries_;
        return space_.is_clear(from, to);
    }

    AxisValues next_sample(int number) {
        const double share = std::min(1.0, kInitialMargin + static_cast<double>(number) / kGrowthSamples);
        const AxisValues margin = share * (space_.high - space_.low);
        const AxisValues low = (from_.cwiseMin(to_) - margin).cwiseMax(space_.low);
        const AxisValues high = (from_.cwiseMax(to_) + margin).cwiseMin(space_.high);
        AxisValues sample(low.size());
        for (Eigen::Index i = 0; i < low.size(); ++i) {
            const double position = low[i] + numbers_.share() * (high[i] - low[i]);
            const double choice = numbers_.share();
            sample[i] = choice < keep_probability_ / 2 ? from_[i]
                        : choice < keep_probability_   ? to_[i]
                                                       : snap_to_grid(position);
        }
        return sample;
    }

    std::optional<std::size_t> grow(Tree& tree, const AxisValues& target) {
        const std::size_t near = tree.nearest(target, space_.s_per_unit);
        const AxisValues start = tree.node(near);
        for (const double share : kShares) {
            const AxisValues end = share == 1 ? target : snap_to_grid(start + share * (target - start));
            if (end == start || remaining_queries_ <= 0) break;
            if (is_clear(start, end)) return tree.add(end, near);
        }
        return std::nullopt;
    }

    // Grows as far as possible; returns the node if it has arrived there.
    std::optional<std::size_t> connect(Tree& tree, const AxisValues& target) {
        while (true) {
            const std::size_t near = tree.nearest(target, space_.s_per_unit);
            if (tree.node(near) == target) return near;
            const auto new_node = grow(tree, target);
            if (!new_node) return std::nullopt;
            if (tree.node(*new_node) == target) return new_node;
        }
    }

    // Both paths meet in one node.
    static AxisPath joined(const std::array<Tree, 2>& trees, std::size_t first_node,
                           std::size_t second_node) {
        AxisPath path = trees[0].path_to(first_node);
        AxisPath back = trees[1].path_to(second_node);
        path.insert(path.end(), std::next(back.rbegin()), back.rend());
        path.erase(path.begin());
        return path;
    }

    const SearchSpace& space_;
    const AxisValues& from_;
    const AxisValues& to_;
    int remaining_queries_;
    double keep_probability_;
    RandomNumbers numbers_;
};

// Connects each node to the last one that it can reach.
AxisPath remove_redundant_nodes(const SearchSpace& space, const AxisValues& from, const AxisPath& path) {
    AxisPath kept;
    const AxisValues* at = &from;
    for (std::size_t next = 0; next < path.size();) {
        std::size_t last = path.size() - 1;
        while (last > next && !space.is_clear(*at, path[last])) --last;
        kept.push_back(path[last]);
        at = &path[last];
        next = last + 1;
    }
    return kept;
}

// A position on a path: on its section to a node.
struct PathPosition {
    std::size_t path_segment;
    AxisValues at;
};

PathPosition random_position(RandomNumbers& numbers, const AxisValues& from, const AxisPath& path) {
    const std::size_t path_segment = numbers.random_index(path.size());
    const AxisValues& start = path_segment == 0 ? from : path[path_segment - 1];
    return {path_segment, snap_to_grid(start + numbers.share() * (path[path_segment] - start))};
}

}  // namespace

double path_duration_s(const SearchSpace& space, const AxisValues& from, const AxisPath& path) {
    double seconds = 0;
    const AxisValues* at = &from;
    for (const AxisValues& node : path) {
        seconds += space.seconds(*at, node);
        at = &node;
    }
    return seconds;
}

AxisPath shortcut(const SearchSpace& space, const AxisValues& from, AxisPath path) {
    path = remove_redundant_nodes(space, from, path);
    RandomNumbers numbers(1);
    for (int i = 0; i < kShortcutAttempts && path.size() > 1; ++i) {
        PathPosition a = random_position(numbers, from, path);
        PathPosition b = random_position(numbers, from, path);
        if (a.path_segment == b.path_segment) continue;
        if (a.path_segment > b.path_segment) std::swap(a, b);
        AxisPath candidate_path(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(a.path_segment));
        const AxisValues before = candidate_path.empty() ? from : candidate_path.back();
        candidate_path.push_back(a.at);
        candidate_path.push_back(b.at);
        candidate_path.insert(candidate_path.end(),
                              path.begin() + static_cast<std::ptrdiff_t>(b.path_segment), path.end());
        if (path_duration_s(space, from, candidate_path) >= path_duration_s(space, from, path)) continue;
        // A position that was rounded to the grid is no longer exactly on its section.
        if (space.is_clear(before, a.at) && space.is_clear(a.at, b.at) &&
            space.is_clear(b.at, path[b.path_segment]))
            path = std::move(candidate_path);
    }
    return remove_redundant_nodes(space, from, path);
}

std::optional<AxisPath> search_path(const SearchSpace& space, const AxisValues& from, const AxisValues& to,
                                    int max_queries) {
    if (space.is_clear(from, to)) return AxisPath{to};
    std::optional<AxisPath> best;
    for (std::uint32_t seed = 1; seed <= kSearchCount; ++seed) {
        auto path = Search(space, from, to, max_queries, seed).run();
        if (!path && !best && seed == kMaxFailedSearches) break;
        if (!path) continue;
        path = shortcut(space, from, *std::move(path));
        if (!best || path_duration_s(space, from, *path) < path_duration_s(space, from, *best))
            best = std::move(path);
    }
    return best;
}

}  // namespace gsim::linking
