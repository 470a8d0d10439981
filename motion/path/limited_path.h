#pragma once

#include <optional>

#include <tl/expected.hpp>

#include "motion/lookahead/block.h"

namespace gsim::motion {

// Moves with joint accelerations that MoveLimits set for each of them. The setup has such limits.

/// Returns the setup with the accelerations of one move under the operator's overrides, and with the speeds
/// up to which they are valid. Errors: RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
tl::expected<PlannerSetup, PlanError> setup_for_path(const PathMove& move, const PlannerSetup& setup,
                                                     const Overrides& overrides);

/// Returns make_block() with these.
tl::expected<std::optional<Block>, PlanError> limited_block(const PathMove& move, const PlannerSetup& setup,
                                                            const Overrides& overrides);

/// Returns what each joint may have in either direction while a corner is passed, on the parts that a blend
/// may use of both paths. Returns nullopt if the joints cannot continue from one path to the other.
std::optional<rrs::JointPos> corner_accelerations(const PlannerSetup& setup, const Block& from,
                                                  const Block& to);

/// Returns the setup with the accelerations of a corner.
PlannerSetup setup_for_corner(const PlannerSetup& setup, const rrs::JointPos& accelerations);

}  // namespace gsim::motion
