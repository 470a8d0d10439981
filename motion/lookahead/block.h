#pragma once

#include <algorithm>
#include <optional>

#include <tl/expected.hpp>

#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// The measure of a way: the joints of one role lead, and the others go in proportion.
/// position: mm of the tool's way; secondary: mm of other prismatic joints; rotary: rad, the norm of the
/// angles.
struct Lead {
    JointRole role = JointRole::position;
    double length = 0;
};

/// How the corner at the start of a block is rounded; see blend.h.
struct Blend {
    double cut =
        0;  ///< Off the end of the block before and off the start of this one; 0: the corner is exact.
    bool smooth = false;      ///< The acceleration grows and falls; else it is constant.
    double deviation_mm = 0;  ///< How far the tool passes from the corner.
};

/// What an exact stop waits for.
struct Settling {
    double fixed_s = 0;
    double in_position_mm = kUnlimited;
    double in_position_rad = kUnlimited;
};

/// What ramps in steps of time (SteppedRamps) may take along a way. The block is then planned with a mean
/// acceleration.
struct SteppedLimits {
    double acceleration = 0;
    double jerk = 0;
};

/// A move in a look-ahead window: its way, the limits along it, and what is planned for its ends. All along
/// the way by the measure of the lead joints (mm or rad).
struct Block {
    PathMove move;
    Lead lead;
    rrs::JointPos slope_in;   ///< Change of the joints by length of way at the start
    rrs::JointPos slope_out;  ///< and at the end.
    double max_speed = kUnlimited;
    LimitedBy speed_limit;
    double acceleration = kUnlimited;
    LimitedBy acceleration_limit;
    double deceleration = kUnlimited;
    double jerk = kUnlimited;
    LimitedBy jerk_limit;
    std::optional<SteppedLimits> steps;  ///< Where its ramps go in steps of time.
    /// What the joints may have at the corner at its start, where MoveLimits say so.
    std::optional<rrs::JointPos> corner_accelerations;
    Settling settling;                        ///< At its end, if that is an exact stop.
    Blend entry_blend;                        ///< At its start.
    double exit_cut = 0;                      ///< What the blend at its end cuts off.
    double entry_cap = 0;                     ///< The speed at which its start may be passed at most,
    LimitKind entry_limit = LimitKind::stop;  ///< and why.
    double entry = 0;                         ///< The speed at its start by what is known so far.
    bool by_window = false;                   ///< `entry` is low because nothing further is known.

    /// What blends leave of it.
    double way() const { return std::max(lead.length - entry_blend.cut - exit_cut, 0.0); }
    /// The joints after a length of way, of a line.
    rrs::JointPos line_at(double length) const;
    LawLimits limits() const { return {max_speed, acceleration, deceleration, jerk}; }
};

/// The way of a move and its limits under the operator's overrides; no value where it goes nowhere (changes
/// below 1e-9 mm or rad are none). All joints go in proportion, so the slowest sets the pace.
/// RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
tl::expected<std::optional<Block>, PlanError> block_of(const PathMove& move, const PlannerSetup& setup,
                                                       const Overrides& overrides = {});

}  // namespace gsim::motion
