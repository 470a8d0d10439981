#pragma once

#include <tl/expected.hpp>

#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion::klipper {

/// The squared speeds that one of the two plans has for a move, in (mm/s)^2 or (rad/s)^2.
struct Plan {
    double change = 0;     ///< By how much the square can change on the way.
    double entry_cap = 0;  ///< At its start, by its junction and by what the moves before it can reach.
    double entry = 0;      ///< At its start, by what follows as well.
};

/// A straight move that waits for its speeds, with the limits that held when it was read.
struct QueuedMove {
    rrs::TargetId target_id = 0;
    bool reaches_target = true;
    rrs::JointPos start;
    rrs::JointPos end;
    rrs::JointPos slope;  ///< Change of the joints by length of way.
    /// The tool moves. Else extruders or rotary joints move alone: such a move begins and ends at rest.
    bool moves_tool = true;
    bool stops = false;    ///< The program asks for an exact stop at its end.
    double length = 0;     ///< mm of the tool's way, or of the extruder's; rad
    double length_mm = 0;  ///< As Segment has it.

    double max_speed = kUnlimited;
    double acceleration = kUnlimited;
    LimitedBy speed_limit;
    LimitedBy acceleration_limit;
    double junction_deviation_mm = 0;  ///< Of the circle that stands for a corner.

    Plan full;               ///< With the acceleration of the move: how fast its ends are.
    Plan smooth;             ///< With what the minimum cruise ratio leaves of it: how fast it becomes.
    bool speeds_up = false;  ///< The smooth plan does: it can begin no faster, for all that follows.
    double top = 0;          ///< The squared speed that it cruises at.

    double max_speed_squared() const { return max_speed * max_speed; }
};

/// The move of a line; of length 0 where it goes nowhere. RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
tl::expected<QueuedMove, PlanError> queued_move(const PlannerSetup& setup, const PathMove& line);

}  // namespace gsim::motion::klipper
