#include "cam/linking/way_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace gsim::transit {

namespace {

// Resolution of a node in programs.
constexpr double kGrid = 1e-3;
// Number of samples in which the search space, starting from the box about both ends, grows by the full axis
// ranges.
constexpr int kGrowth = 60;
constexpr double kFirstShare = 0.02;
// A branch that is not clear is tried at a half, a quarter, an eighth of its length.
constexpr std::array<double, 4> kShares{1, 0.5, 0.25, 0.125};
constexpr int kShortcuts = 100;
// Number of searches; the fastest path counts.
constexpr std::uint32_t kSearches = 6;
// Number of failed searches after which the search ends.
constexpr std::uint32_t kVainSearches = 3;
// In all but every third search, an axis of a sample stays at its value of one of the ends with this
// probability: many axes need not move. That finds faster paths, but does not pass all narrow gaps.
constexpr double kStays = 0.4;

double on_grid(double value) {
    return std::round(value / kGrid) * kGrid;
}

AxisValues on_grid(const AxisValues& node) {
    return node.unaryExpr([](double value) { return on_grid(value); });
}

// Random numbers that are the same with any library; the distributions of the standard do not guarantee that.
class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : engine_(seed) {}

    double share() { return static_cast<double>(engine_()) / 4294967296.0; }
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(share() * static_cast<double>(count));
    }

  private:
    std::mt19937 engine_;
};

class Tree {
  public:
    explicit Tree(AxisValues root) : nodes_{std::move(root)}, parents_{0} {}

    std::size_t nearest(const AxisValues& to, const AxisValues& pace) const {
        std::size_t best = 0;
        double least = far_s(nodes_[0], to, pace);
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            const double s = far_s(nodes_[i], to, pace);
            if (s < least) {
                least = s;
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
    Way way_to(std::size_t node) const {
        Way way{nodes_[node]};
        for (; node != 0; node = parents_[node]) way.push_back(nodes_[parents_[node]]);
        std::reverse(way.begin(), way.end());
        return way;
    }

  private:
    static double far_s(const AxisValues& a, const AxisValues& b, const AxisValues& pace) {
        return ((a - b).cwiseAbs().cwiseProduct(pace)).maxCoeff();
    }

    std::vector<AxisValues> nodes_;
    std::vector<std::size_t> parents_;
};

class Search {
  public:
    Search(const WaySpace& space, const AxisValues& from, const AxisValues& to, int most_questions,
           std::uint32_t seed)
        : space_(space),
          from_(from),
          to_(to),
          left_(most_questions),
          stays_(seed % 3 != 0 ? kStays : 0),
          numbers_(seed) {}

    std::optional<Way> run() {
        std::array<Tree, 2> trees{Tree(from_), Tree(to_)};
        for (int sample = 0; left_ > 0; ++sample) {
            const std::size_t own = sample % 2 == 0 ? 0 : 1;
            const auto grown = grow(trees[own], next_sample(sample));
            if (!grown) continue;
            const AxisValues meeting = trees[own].node(*grown);
            if (const auto met = connect(trees[1 - own], meeting))
                return own == 0 ? joined(trees, *grown, *met) : joined(trees, *met, *grown);
        }
        return std::nullopt;
    }

  private:
    bool is_clear(const AxisValues& from, const AxisValues& to) {
        --left_;
        return space_.is_clear(from, to);
    }

    AxisValues next_sample(int number) {
        const double share = std::min(1.0, kFirstShare + static_cast<double>(number) / kGrowth);
        const AxisValues margin = share * (space_.high - space_.low);
        const AxisValues low = (from_.cwiseMin(to_) - margin).cwiseMax(space_.low);
        const AxisValues high = (from_.cwiseMax(to_) + margin).cwiseMin(space_.high);
        AxisValues sample(low.size());
        for (Eigen::Index i = 0; i < low.size(); ++i) {
            const double place = low[i] + numbers_.share() * (high[i] - low[i]);
            const double choice = numbers_.share();
            sample[i] = choice < stays_ / 2 ? from_[i] : choice < stays_ ? to_[i] : on_grid(place);
        }
        return sample;
    }

    std::optional<std::size_t> grow(Tree& tree, const AxisValues& towards) {
        const std::size_t near = tree.nearest(towards, space_.pace);
        const AxisValues start = tree.node(near);
        for (const double share : kShares) {
            const AxisValues end = share == 1 ? towards : on_grid(start + share * (towards - start));
            if (end == start || left_ <= 0) break;
            if (is_clear(start, end)) return tree.add(end, near);
        }
        return std::nullopt;
    }

    // Grows as far as possible; returns the node if it has arrived there.
    std::optional<std::size_t> connect(Tree& tree, const AxisValues& towards) {
        while (true) {
            const std::size_t near = tree.nearest(towards, space_.pace);
            if (tree.node(near) == towards) return near;
            const auto grown = grow(tree, towards);
            if (!grown) return std::nullopt;
            if (tree.node(*grown) == towards) return grown;
        }
    }

    // Both paths meet in one node.
    static Way joined(const std::array<Tree, 2>& trees, std::size_t of_first, std::size_t of_second) {
        Way way = trees[0].way_to(of_first);
        Way back = trees[1].way_to(of_second);
        way.insert(way.end(), std::next(back.rbegin()), back.rend());
        way.erase(way.begin());
        return way;
    }

    const WaySpace& space_;
    const AxisValues& from_;
    const AxisValues& to_;
    int left_;
    double stays_;
    Numbers numbers_;
};

// Connects each node to the last one that it can reach.
Way without_needless(const WaySpace& space, const AxisValues& from, const Way& way) {
    Way kept;
    const AxisValues* at = &from;
    for (std::size_t next = 0; next < way.size();) {
        std::size_t last = way.size() - 1;
        while (last > next && !space.is_clear(*at, way[last])) --last;
        kept.push_back(way[last]);
        at = &way[last];
        next = last + 1;
    }
    return kept;
}

// A position on a path: on its section to a node.
struct OnWay {
    std::size_t stretch;
    AxisValues at;
};

OnWay any_place(Numbers& numbers, const AxisValues& from, const Way& way) {
    const std::size_t stretch = numbers.below(way.size());
    const AxisValues& start = stretch == 0 ? from : way[stretch - 1];
    return {stretch, on_grid(start + numbers.share() * (way[stretch] - start))};
}

}  // namespace

double seconds_of(const WaySpace& space, const AxisValues& from, const Way& way) {
    double seconds = 0;
    const AxisValues* at = &from;
    for (const AxisValues& node : way) {
        seconds += space.seconds(*at, node);
        at = &node;
    }
    return seconds;
}

Way shortened(const WaySpace& space, const AxisValues& from, Way way) {
    way = without_needless(space, from, way);
    Numbers numbers(1);
    for (int i = 0; i < kShortcuts && way.size() > 1; ++i) {
        OnWay a = any_place(numbers, from, way);
        OnWay b = any_place(numbers, from, way);
        if (a.stretch == b.stretch) continue;
        if (a.stretch > b.stretch) std::swap(a, b);
        Way shorter(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(a.stretch));
        const AxisValues before = shorter.empty() ? from : shorter.back();
        shorter.push_back(a.at);
        shorter.push_back(b.at);
        shorter.insert(shorter.end(), way.begin() + static_cast<std::ptrdiff_t>(b.stretch), way.end());
        if (seconds_of(space, from, shorter) >= seconds_of(space, from, way)) continue;
        // A position that was rounded to the grid is no longer exactly on its section.
        if (space.is_clear(before, a.at) && space.is_clear(a.at, b.at) &&
            space.is_clear(b.at, way[b.stretch]))
            way = std::move(shorter);
    }
    return without_needless(space, from, way);
}

std::optional<Way> search_way(const WaySpace& space, const AxisValues& from, const AxisValues& to,
                              int most_questions) {
    if (space.is_clear(from, to)) return Way{to};
    std::optional<Way> best;
    for (std::uint32_t seed = 1; seed <= kSearches; ++seed) {
        auto way = Search(space, from, to, most_questions, seed).run();
        if (!way && !best && seed == kVainSearches) break;
        if (!way) continue;
        way = shortened(space, from, *std::move(way));
        if (!best || seconds_of(space, from, *way) < seconds_of(space, from, *best)) best = std::move(way);
    }
    return best;
}

}  // namespace gsim::transit
