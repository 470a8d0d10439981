#pragma once

#include <memory>

#include <tl/expected.hpp>

#include "controller/services/types.h"
#include "motion/path/master_path.h"
#include "motion/path/orientation_arc.h"
#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Returns a message that explains why the machine or its controller cannot turn the tool along great
/// circles, or nullopt if they can.
std::optional<std::string> find_great_circle_error(const PlannerSetup& setup);

/// Returns the path of a head's joints along the great circle, for a machine that supports it. Returns null
/// if the tool direction stays the same: then joints move in proportion, such as the turning joint of an
/// upright tool. Errors: RRS_NO_SOLUTION if no great circle leads to the target's joint values,
/// RRS_JOINT_LIMIT if the tilt would leave its range on the path.
tl::expected<std::shared_ptr<const OrientationArc>, PlanError> orientation_between(const PlannerSetup& setup,
                                                                                   const rrs::JointPos& start,
                                                                                   const rrs::JointPos& end);

/// Lowers the limits of a leading path so that the head joints, which move evenly with it, keep their own
/// limits all along the arc: |q'| v <= V, |q''| v^2 + |q'| a <= A, |q'''| v^3 + 3 |q''| v a + |q'| j <= J,
/// with the bounds of the derivatives by path length. The speed gets at most half of an acceleration and a
/// quarter of a jerk if the joint path is curved. Must be called once all other limits are in `master`.
void limit_by_head(const PlannerSetup& setup, const OrientationArc& arc, MasterPath& master);

/// Does the same, and applies the programmed speed and acceleration of orientation, which count along the
/// great circle.
void limit_by_orientation(const PlannerSetup& setup, const MoveRules& rules, const OrientationArc& arc,
                          MasterPath& master);

}  // namespace gsim::motion
