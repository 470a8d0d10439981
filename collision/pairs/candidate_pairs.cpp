#include "collision/pairs/candidate_pairs.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace gsim::cell {

namespace {

bool moves_with_links(Role role) {
    return role == Role::machine || role == Role::jet;
}

/// Lookup of the pairs of a cell that may touch each other.
class IgnoredPairs {
  public:
    explicit IgnoredPairs(const Cell& cell) {
        pairs_.reserve(cell.ignored.size());
        for (const auto& [a, b] : cell.ignored) pairs_.emplace_back(std::minmax(a, b));
        std::sort(pairs_.begin(), pairs_.end());
    }
    /// Expects `a` before `b`.
    bool contain(std::size_t a, std::size_t b) const {
        return std::binary_search(pairs_.begin(), pairs_.end(), std::pair(a, b));
    }

  private:
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Joints between two links, found once for each pair of links.
class LinkJoints {
  public:
    LinkJoints(const Cell& cell, const kinematics::Kinematics& kinematics)
        : kinematics_(kinematics), parents_(moving_frame_parents(cell)) {}

    const std::vector<int>& between(int a, int b) {
        const auto [found, is_new] = joints_.try_emplace({a, b});
        if (is_new) found->second = joints_between(kinematics_, a, b, parents_);
        return found->second;
    }

  private:
    const kinematics::Kinematics& kinematics_;
    std::vector<int> parents_;
    std::map<std::pair<int, int>, std::vector<int>> joints_;
};

// Excludes bodies that do not move relative to each other, because they cannot meet. Neighbouring parts of
// the machine in the chain are made to touch.
std::optional<CandidatePair> make_candidate_pair(const Cell& cell, LinkJoints& joints,
                                                 const IgnoredPairs& ignored, std::size_t a, std::size_t b) {
    const Role role_a = cell.items[a].role;
    const Role role_b = cell.items[b].role;
    const std::vector<int>& between =
        joints.between(cell.frames.link(cell.items[a].frame), cell.frames.link(cell.items[b].frame));
    if (between.empty() || ignored.contain(a, b)) return std::nullopt;
    if (between.size() == 1 && moves_with_links(role_a) && moves_with_links(role_b)) return std::nullopt;
    const bool jet = role_a == Role::jet || role_b == Role::jet;
    if (jet && (role_a == Role::workpiece || role_b == Role::workpiece)) return std::nullopt;
    const Body body_a = make_body(cell, a);
    const Body body_b = make_body(cell, b);
    // A body that is fixed in the world is the one at standstill.
    if (body_b.link == 0) return CandidatePair{{a, b}, jet, {body_a, body_b, between}};
    return CandidatePair{{b, a}, jet, {body_b, body_a, {between.rbegin(), between.rend()}}};
}

/// Returns for each item the next one that is not on its link: items in between never meet it.
std::vector<std::size_t> next_item_on_other_link(const Cell& cell) {
    const auto link = [&](std::size_t item) { return cell.frames.link(cell.items[item].frame); };
    std::vector<std::size_t> next(cell.items.size(), cell.items.size());
    for (std::size_t i = cell.items.size(); i-- > 1;) next[i - 1] = link(i - 1) == link(i) ? next[i] : i;
    return next;
}

}  // namespace

Body make_body(const Cell& cell, std::size_t item) {
    const Item& of = cell.items[item];
    return {&of.shape, cell.frames.link(of.frame), cell.frames.pose_in_link(of.frame)};
}

std::vector<int> moving_frame_parents(const Cell& cell) {
    std::vector<int> parents;
    parents.reserve(cell.moving_frames.size());
    for (const MovingFrame& moving_frames : cell.moving_frames)
        parents.push_back(cell.frames.link(cell.frames.parent(moving_frames.frame)));
    return parents;
}

std::vector<CandidatePair> candidate_pairs(const Cell& cell, const kinematics::Kinematics& kinematics) {
    std::vector<CandidatePair> pairs;
    LinkJoints joints(cell, kinematics);
    const IgnoredPairs ignored(cell);
    const std::vector<std::size_t> next = next_item_on_other_link(cell);
    const auto link = [&](std::size_t item) { return cell.frames.link(cell.items[item].frame); };
    for (std::size_t a = 0; a < cell.items.size(); ++a) {
        for (std::size_t b = a + 1; b < cell.items.size();) {
            if (link(a) == link(b)) {
                b = next[b];
                continue;
            }
            if (auto pair = make_candidate_pair(cell, joints, ignored, a, b))
                pairs.push_back(*std::move(pair));
            ++b;
        }
    }
    return pairs;
}

std::optional<Error> find_pair_count_error(std::span<const Item> items, const FrameTree& frames) {
    std::map<int, std::size_t> count_on_link;
    for (const Item& item : items) ++count_on_link[frames.link(item.frame)];
    std::size_t pairs = 0;
    std::size_t before = 0;
    for (const auto& [link, count] : count_on_link) {
        pairs += before * count;
        before += count;
    }
    if (pairs <= kMaxCandidatePairs) return std::nullopt;
    return fmt::format(
        "{} bodies form {} pairs on parts that move relative to each other; at most {} can be monitored",
        items.size(), pairs, kMaxCandidatePairs);
}

}  // namespace gsim::cell
