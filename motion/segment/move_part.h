#pragma once

#include <array>

#include "motion/planner/motion_model.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// Where the operator turns an override a motion is cut there and goes on by another law.

inline constexpr double kLeastPart = 1e-6;  ///< mm or rad: nothing is cut so near to its ends.
inline constexpr double kNoSpeed = 1e-9;    ///< mm/s or rad/s: what is as slow stands.

/// The part of a move between two places of its way, which is `length` long by the measure of its lead (mm or
/// rad). A time that is programmed for the move is shared out.
PathMove move_part(const PathMove& move, double length, double from, double to,
                   const std::array<int, 3>& position_joints);

/// Gives a segment the way of a move; its laws are yet to be set.
void set_way(const PathMove& move, Segment& segment);

/// The first instant of a law from `t_s` on at which another law may go on: any where nothing limits the
/// jerk, else one without acceleration.
double turning_s(const TimeLaw& law, double t_s, double jerk);

}  // namespace gsim::motion
