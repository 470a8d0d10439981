#pragma once

#include <tl/expected.hpp>

#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion::klipper {

/// Squared speeds of one of the two plans for a move, in (mm/s)^2 or (rad/s)^2.
struct Plan {
    double change = 0;  ///< Possible change of the square along the path.
    double entry_cap_squared =
        0;                     ///< At its start, by its junction and by what the moves before it can reach.
    double entry_squared = 0;  ///< At its start, by what follows as well.
};

/// Straight move that waits for its speeds, with the limits that were active when it was read.
struct QueuedMove {
    rrs::TargetId target_id = 0;
    bool reaches_target = true;
    rrs::JointPos start;
    rrs::JointPos end;
    rrs::JointPos slope;  ///< Change of the joints per path length.
    /// True if the tool moves. Otherwise only extruders or rotary joints move, and the move begins and ends
    /// at standstill.
    bool moves_tool = true;
    bool stops = false;    ///< True if the program requests an exact stop at its end.
    double length = 0;     ///< mm of the tool path, or of the extruder; rad
    double length_mm = 0;  ///< As Segment has it.

    double max_speed = kUnlimited;
    double acceleration = kUnlimited;
    LimitCause speed_limit;
    LimitCause acceleration_limit;
    double junction_deviation_mm = 0;  ///< Deviation of the circle for a corner.

    Plan full;               ///< With the acceleration of the move: how fast its ends are.
    Plan smooth;             ///< With what the minimum cruise ratio leaves of it: how fast it becomes.
    bool speeds_up = false;  ///< The smooth plan does: it can begin no faster, for all that follows.
    double cruise_speed_squared = 0;

    double max_speed_squared() const { return max_speed * max_speed; }
};

/// Returns the move of a line; its length is 0 if nothing moves. Errors: RRS_ZERO_SPEED,
/// RRS_INVALID_PARAMETER.
tl::expected<QueuedMove, PlanError> queued_move(const PlannerSetup& setup, const PathMove& line);

}  // namespace gsim::motion::klipper
