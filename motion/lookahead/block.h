#pragma once

#include <algorithm>
#include <optional>

#include <tl/expected.hpp>

#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Measure of a path: the joints of one role are the masters, and the others move in proportion. position: mm
/// of the tool path; secondary: mm of other prismatic joints; rotary: rad, the norm of the angles.
struct MasterJoints {
    JointRole role = JointRole::position;
    double length = 0;
};

/// Rounding of the corner at the start of a block; see blend.h.
struct Blend {
    double cut =
        0;  ///< Off the end of the block before and off the start of this one; 0: the corner is exact.
    bool smooth = false;      ///< The acceleration grows and falls; else it is constant.
    double deviation_mm = 0;  ///< Distance of the tool from the corner.
};

/// Wait conditions of an exact stop.
struct Settling {
    double fixed_s = 0;
    double in_position_mm = kUnlimited;
    double in_position_rad = kUnlimited;
};

/// Limits of ramps in steps of time (SteppedRamps) along a path. The block is then planned with a mean
/// acceleration.
struct SteppedLimits {
    double acceleration = 0;
    double jerk = 0;
};

/// Move in a look-ahead window: its path, the limits along it, and the plan for its ends. All values along
/// the path use the measure of the master joints (mm or rad).
struct Block {
    PathMove move;
    MasterJoints master;
    rrs::JointPos slope_in;   ///< Change of the joints per path length at the start
    rrs::JointPos slope_out;  ///< and at the end.
    double max_speed = kUnlimited;
    LimitCause speed_limit;
    double acceleration = kUnlimited;
    LimitCause acceleration_limit;
    double deceleration = kUnlimited;
    double jerk = kUnlimited;
    LimitCause jerk_limit;
    std::optional<SteppedLimits> steps;  ///< Set if its ramps run in steps of time.
    /// Accelerations of the joints at the corner at its start, if MoveLimits set them.
    std::optional<rrs::JointPos> corner_accelerations;
    Settling settling;                        ///< At its end, if that is an exact stop.
    Blend entry_blend;                        ///< At its start.
    double exit_cut = 0;                      ///< Length that the blend at its end cuts off.
    double entry_cap = 0;                     ///< Max speed at which its start may be passed,
    LimitKind entry_limit = LimitKind::stop;  ///< and why.
    double entry = 0;                         ///< The speed at its start by what is known so far.
    bool is_window_limited = false;           ///< True if `entry` is low because no further block is known.

    /// Returns the path length that blends leave.
    double distance() const { return std::max(master.length - entry_blend.cut - exit_cut, 0.0); }
    /// Returns the joints at a path length, for a line.
    rrs::JointPos line_at(double length) const;
    LawLimits limits() const { return {max_speed, acceleration, deceleration, jerk}; }
};

/// Returns the path of a move and its limits under the operator's overrides, or no value if nothing moves
/// (changes below 1e-9 mm or rad do not count). All joints move in proportion, so the slowest sets the speed.
/// Errors: RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
tl::expected<std::optional<Block>, PlanError> make_block(const PathMove& move, const PlannerSetup& setup,
                                                         const Overrides& overrides = {});

}  // namespace gsim::motion
