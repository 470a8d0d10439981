#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "collision/cell/cell.h"
#include "collision/pairs/body_pair.h"

namespace gsim::cell {

/// Two items of a cell, as indices.
struct ItemPair {
    std::size_t first;
    std::size_t second;
};

/// Candidate pair: two bodies of a cell that may meet.
struct CandidatePair {
    ItemPair items;
    bool includes_jet;
    BodyPair bodies;
};

/// Max number of body pairs that are monitored, some 500 bytes each.
inline constexpr std::size_t kMaxCandidatePairs = 1'000'000;

/// Returns an error if these are too many items: pairs on different links may meet.
std::optional<Error> find_pair_count_error(std::span<const Item> items, const FrameTree& frames);

/// Returns an item of a cell as a body on its link. The cell must outlive it.
Body make_body(const Cell& cell, std::size_t item);

/// Returns the links that carry independently moving frames, in the order of those frames (joints_between()).
std::vector<int> moving_frame_parents(const Cell& cell);

/// Returns the pairs to check. It excludes pairs without relative motion, neighbouring parts of the machine,
/// the jet and workpieces, and those that the cell ignores. The cell must outlive them.
std::vector<CandidatePair> candidate_pairs(const Cell& cell, const kinematics::Kinematics& kinematics);

}  // namespace gsim::cell
