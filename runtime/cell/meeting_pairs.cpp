#include "runtime/cell/meeting_pairs.h"

#include <algorithm>
#include <optional>
#include <span>

namespace gsim::cell {

namespace {

bool moves_with_links(Role role) {
    return role == Role::machine || role == Role::jet;
}

bool is_ignored(const Cell& cell, std::size_t a, std::size_t b) {
    return std::any_of(cell.ignored.begin(), cell.ignored.end(), [&](const auto& pair) {
        return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
    });
}

// Bodies that do not move against each other cannot meet. Parts of the machine next to each other in the
// chain are made to touch.
std::optional<MeetingPair> meeting_pair(const Cell& cell, const kinematics::Kinematics& kinematics,
                                        std::span<const int> parents, std::size_t a, std::size_t b) {
    const Body of_a = body_of(cell, a);
    const Body of_b = body_of(cell, b);
    const Role role_a = cell.items[a].role;
    const Role role_b = cell.items[b].role;
    const std::vector<int> between = joints_between(kinematics, of_a.link, of_b.link, parents);
    if (between.empty() || is_ignored(cell, a, b)) return std::nullopt;
    if (between.size() == 1 && moves_with_links(role_a) && moves_with_links(role_b)) return std::nullopt;
    const bool jet = role_a == Role::jet || role_b == Role::jet;
    if (jet && (role_a == Role::workpiece || role_b == Role::workpiece)) return std::nullopt;
    // What stands in the world is the one at rest.
    if (of_b.link == 0) return MeetingPair{{a, b}, jet, {of_a, of_b, between}};
    return MeetingPair{{b, a}, jet, {of_b, of_a, {between.rbegin(), between.rend()}}};
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
    const std::vector<int> parents = carried_parents(cell);
    for (std::size_t a = 0; a < cell.items.size(); ++a) {
        for (std::size_t b = a + 1; b < cell.items.size(); ++b) {
            if (auto pair = meeting_pair(cell, kinematics, parents, a, b)) pairs.push_back(*std::move(pair));
        }
    }
    return pairs;
}

}  // namespace gsim::cell
