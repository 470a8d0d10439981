#include "collision/pairs/meeting_pairs.h"

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
    bool hold(std::size_t a, std::size_t b) const {
        return std::binary_search(pairs_.begin(), pairs_.end(), std::pair(a, b));
    }

  private:
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Joints between two links, found once for each pair of links.
class LinkJoints {
  public:
    LinkJoints(const Cell& cell, const kinematics::Kinematics& kinematics)
        : kinematics_(kinematics), parents_(carried_parents(cell)) {}

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
std::optional<MeetingPair> meeting_pair(const Cell& cell, LinkJoints& joints, const IgnoredPairs& ignored,
                                        std::size_t a, std::size_t b) {
    const Role role_a = cell.items[a].role;
    const Role role_b = cell.items[b].role;
    const std::vector<int>& between =
        joints.between(cell.frames.link(cell.items[a].frame), cell.frames.link(cell.items[b].frame));
    if (between.empty() || ignored.hold(a, b)) return std::nullopt;
    if (between.size() == 1 && moves_with_links(role_a) && moves_with_links(role_b)) return std::nullopt;
    const bool jet = role_a == Role::jet || role_b == Role::jet;
    if (jet && (role_a == Role::workpiece || role_b == Role::workpiece)) return std::nullopt;
    const Body of_a = body_of(cell, a);
    const Body of_b = body_of(cell, b);
    // A body that is fixed in the world is the one at standstill.
    if (of_b.link == 0) return MeetingPair{{a, b}, jet, {of_a, of_b, between}};
    return MeetingPair{{b, a}, jet, {of_b, of_a, {between.rbegin(), between.rend()}}};
}

/// Returns for each item the next one that is not on its link: items in between never meet it.
std::vector<std::size_t> next_on_other_links(const Cell& cell) {
    const auto link = [&](std::size_t item) { return cell.frames.link(cell.items[item].frame); };
    std::vector<std::size_t> next(cell.items.size(), cell.items.size());
    for (std::size_t i = cell.items.size(); i-- > 1;) next[i - 1] = link(i - 1) == link(i) ? next[i] : i;
    return next;
}

}  // namespace

Body body_of(const Cell& cell, std::size_t item) {
    const Item& of = cell.items[item];
    return {&of.shape, cell.frames.link(of.frame), cell.frames.in_link(of.frame)};
}

std::vector<int> carried_parents(const Cell& cell) {
    std::vector<int> parents;
    parents.reserve(cell.carried.size());
    for (const CarriedFrame& carried : cell.carried)
        parents.push_back(cell.frames.link(cell.frames.parent(carried.frame)));
    return parents;
}

std::vector<MeetingPair> meeting_pairs(const Cell& cell, const kinematics::Kinematics& kinematics) {
    std::vector<MeetingPair> pairs;
    LinkJoints joints(cell, kinematics);
    const IgnoredPairs ignored(cell);
    const std::vector<std::size_t> next = next_on_other_links(cell);
    const auto link = [&](std::size_t item) { return cell.frames.link(cell.items[item].frame); };
    for (std::size_t a = 0; a < cell.items.size(); ++a) {
        for (std::size_t b = a + 1; b < cell.items.size();) {
            if (link(a) == link(b)) {
                b = next[b];
                continue;
            }
            if (auto pair = meeting_pair(cell, joints, ignored, a, b)) pairs.push_back(*std::move(pair));
            ++b;
        }
    }
    return pairs;
}

std::optional<std::string> find_too_many(std::span<const Item> items, const FrameTree& frames) {
    std::map<int, std::size_t> on_link;
    for (const Item& item : items) ++on_link[frames.link(item.frame)];
    std::size_t pairs = 0;
    std::size_t before = 0;
    for (const auto& [link, count] : on_link) {
        pairs += before * count;
        before += count;
    }
    if (pairs <= kMostMeetingPairs) return std::nullopt;
    return fmt::format(
        "{} bodies are {} pairs on parts that move against each other; up to {} can be watched", items.size(),
        pairs, kMostMeetingPairs);
}

}  // namespace gsim::cell
