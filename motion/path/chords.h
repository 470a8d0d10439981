#pragma once

#include <functional>

#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Returns how many chords an arc becomes if each may be off the circle by `tolerance_mm` > 0: at least 1
/// (grbl 1.1: floor(|angle r / 2| / sqrt(tolerance (2 r - tolerance)))).
int chord_count(const Arc& arc, double tolerance_mm);

/// Returns how many chords the controller makes of an arc: by its tolerance, or by its arc_resolution_mm.
int chord_count(const Arc& arc, const rrs::ControllerRules& controller);

/// Passes on the lines that a circular move becomes, in their order, each a separate move with the same
/// target. The motion outside the position joints is shared out. An inverse time feed becomes a speed: the
/// complete arc takes the time. The speed follows from the number of chords if the controller counts the time
/// once for each chord.
void for_each_chord(const PathMove& move, const PlannerSetup& setup,
                    const std::function<void(const PathMove&)>& on_part);

}  // namespace gsim::motion
