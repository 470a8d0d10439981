#pragma once

#include <vector>

#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// Rapid moves that are not interpolated (CoordinationRules::interpolated_rapids).

/// Plans a move from segment.start to segment.end in which each joint moves by its own limits of speed (times
/// rules.rapid_share), acceleration and jerk. Each joint moves from standstill to standstill and arrives at a
/// separate time. The joint that takes longest is the master; if rules.min_duration_s is longer still, it
/// takes that. Joints that no limit slows down arrive with it. A move of one joint or none is a line.
/// RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
PlanResult plan_uncoordinated_move(const PlannerSetup& setup, const MoveRules& rules, Segment& segment);

/// Returns the length of the tool's path until `t_s` since the start of a segment with uncoordinated joints,
/// to 1e-9 mm.
double uncoordinated_distance_mm(const Segment& segment, double t_s);

/// Returns the time at which the tool has moved `distance_mm` along that path, in s since the start of the
/// segment.
double uncoordinated_time_s(const Segment& segment, double distance_mm);

/// Returns the instants at which a joint changes from one part of its law to the next, in s since the start
/// of the segment, in order: in between all are smooth.
std::vector<double> uncoordinated_instants_s(const Segment& segment);

}  // namespace gsim::motion
