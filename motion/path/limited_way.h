#pragma once

#include <optional>

#include <tl/expected.hpp>

#include "motion/lookahead/block.h"

namespace gsim::motion {

// Moves whose joints have the accelerations that MoveLimits set for each of them. The setup has such limits.

/// The setup with the accelerations of one move under the operator's overrides, and with the speeds up to
/// which they hold. RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
tl::expected<PlannerSetup, PlanError> setup_on_way(const PathMove& move, const PlannerSetup& setup,
                                                   const Overrides& overrides);

/// block_of() with these.
tl::expected<std::optional<Block>, PlanError> limited_block_of(const PathMove& move,
                                                               const PlannerSetup& setup,
                                                               const Overrides& overrides);

/// What each joint may have in either sense while a corner is passed, on all that a blend may take of both
/// ways; nothing where motion on from one to the other is not for the joints.
std::optional<rrs::JointPos> corner_accelerations(const PlannerSetup& setup, const Block& from,
                                                  const Block& to);

/// The setup with the accelerations of a corner.
PlannerSetup setup_at_corner(const PlannerSetup& setup, const rrs::JointPos& accelerations);

}  // namespace gsim::motion
