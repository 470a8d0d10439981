#pragma once

#include <vector>

#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// Rapid moves that are not interpolated (ControllerRules::interpolated_rapids).

/// Plans a move from segment.start to segment.end in which each joint goes by its own limits of speed (times
/// rules.rapid_share), acceleration and jerk, from rest to rest, and arrives at a time of its own. The joint
/// that takes longest leads; where rules.least_duration_s is longer still, it takes that. What no limit slows
/// down arrives with it. A move of one joint or none is a line. RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
Planned plan_apart(const PlannerSetup& setup, const MoveRules& rules, Segment& segment);

/// Of a segment whose joints go apart: the length of the tool's path until `t_s` since its start, to 1e-9 mm.
double apart_way_mm(const Segment& segment, double t_s);

/// When the tool has come `way_mm` along that path, in s since the start of the segment.
double apart_time_s(const Segment& segment, double way_mm);

/// The instants at which a joint changes from one piece of its law to the next, in s since the start of the
/// segment, in order: in between all are smooth.
std::vector<double> apart_instants_s(const Segment& segment);

}  // namespace gsim::motion
