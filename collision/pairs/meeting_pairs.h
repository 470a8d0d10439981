#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "collision/cell/cell.h"
#include "collision/pairs/body_pair.h"

namespace gsim::cell {

/// Two items of a cell, as indices.
struct ItemPair {
    std::size_t first;
    std::size_t second;
};

/// Two bodies of a cell that may meet.
struct MeetingPair {
    ItemPair items;
    bool with_jet;
    BodyPair bodies;
};

/// The most pairs of bodies that are watched, some 500 bytes each.
inline constexpr std::size_t kMostMeetingPairs = 1'000'000;

/// Why these are too many items, as a sentence: the pairs that stand on different links may meet. Nothing
/// where they are not.
std::optional<std::string> find_too_many(std::span<const Item> items, const FrameTree& frames);

/// An item of a cell as a body on its link. The cell must outlive it.
Body body_of(const Cell& cell, std::size_t item);

/// The links that those frames are on which go by themselves, in their order (joints_between()).
std::vector<int> carried_parents(const Cell& cell);

/// The pairs to look at: not those that do not move against each other, neighbouring parts of the machine,
/// the jet and workpieces, and those that the cell ignores. The cell must outlive them.
std::vector<MeetingPair> meeting_pairs(const Cell& cell, const kinematics::Kinematics& kinematics);

}  // namespace gsim::cell
