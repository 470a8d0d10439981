#pragma once

#include <functional>

#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// How many chords an arc becomes where each may lie off the circle by `tolerance_mm` > 0: at least 1
/// (grbl 1.1: floor(|angle r / 2| / sqrt(tolerance (2 r - tolerance)))).
int chord_count(const Arc& arc, double tolerance_mm);

/// As many as the controller makes of an arc: by its tolerance, or by its arc_resolution_mm.
int chord_count(const Arc& arc, const rrs::ControllerRules& controller);

/// The lines that a circular move becomes, in their order, each a move of its own with the same target; what
/// it has beside the position joints is shared out. An inverse time feed becomes a speed: the whole arc takes
/// the time, or, where the controller counts it once for each chord, what that makes.
void for_each_chord(const PathMove& move, const PlannerSetup& setup,
                    const std::function<void(const PathMove&)>& take);

}  // namespace gsim::motion
