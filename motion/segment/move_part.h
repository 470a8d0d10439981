#pragma once

#include <array>

#include "motion/planner/motion_model.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// An override change by the operator cuts a motion, which then continues by another law.

inline constexpr double kMinPart = 1e-6;              ///< mm or rad: no cut is so near to the ends.
inline constexpr double kStandstillTolerance = 1e-9;  ///< mm/s or rad/s: as slow counts as standstill.

/// Returns the part of a move between two positions of its path, which is `length` long by the measure of its
/// leading law (mm or rad). A time that is programmed for the move is shared out.
PathMove move_part(const PathMove& move, double length, double from, double to,
                   const std::array<int, 3>& position_joints);

/// Sets the path of a segment to that of a move; its laws are still to be set.
void set_path(const PathMove& move, Segment& segment);

/// Returns the first instant of a law from `t_s` on at which another law may continue: any if no limit
/// applies to the jerk, otherwise one without acceleration.
double switchable_s(const TimeLaw& law, double t_s, double jerk);

}  // namespace gsim::motion
