#pragma once

#include <memory>

#include <tl/expected.hpp>

#include "controller/services/types.h"
#include "motion/path/lead_path.h"
#include "motion/path/orientation_arc.h"
#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Why the machine or its controller cannot turn the tool along great circles, as a sentence; nothing where
/// they can.
std::optional<std::string> no_great_circles(const PlannerSetup& setup);

/// The way of a head's joints along the great circle, for a machine that can. Null where the direction of the
/// tool stays: then joints go in proportion, such as the turning joint of an upright tool.
/// RRS_NO_SOLUTION where no great circle leads to the target's joint values, RRS_JOINT_LIMIT where the tilt
/// would leave its range on the way.
tl::expected<std::shared_ptr<const OrientationArc>, PlanError> orientation_between(const PlannerSetup& setup,
                                                                                   const rrs::JointPos& start,
                                                                                   const rrs::JointPos& end);

/// Lowers the limits of a lead so that the joints of the head, gone through evenly with it, keep their own
/// all along the arc: |q'| v <= V, |q''| v^2 + |q'| a <= A, |q'''| v^3 + 3 |q''| v a + |q'| j <= J, with the
/// bounds of the derivatives by the way. Where the way of the joints bends, speed gets at most half of an
/// acceleration and a quarter of a jerk. To be called when all other limits are in the lead.
void limit_by_head(const PlannerSetup& setup, const OrientationArc& arc, LeadPath& lead);

/// The same, and the programmed speed and acceleration of orientation, which count along the great circle.
void limit_by_orientation(const PlannerSetup& setup, const MoveRules& rules, const OrientationArc& arc,
                          LeadPath& lead);

}  // namespace gsim::motion
