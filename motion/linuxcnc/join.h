#pragma once

#include <optional>

#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/blend_piece.h"
#include "motion/linuxcnc/piece.h"

namespace gsim::motion::linuxcnc {

/// What junctions are decided by, besides the pieces.
struct JoinRules {
    Planning planning;
    bool stop_between_rapid_and_feed = true;
    double most_share = 1;  ///< Of the programmed speed, that the operator could ask for.
};

/// Decides how `before` ends and how `after` starts: sets both pieces' terms and kinks. Where a blend arc is
/// to stand between them it is answered, and both have been cut.
std::optional<Blend> join(Piece& before, Piece& after, const Axes& axes, const JoinRules& rules);

}  // namespace gsim::motion::linuxcnc
