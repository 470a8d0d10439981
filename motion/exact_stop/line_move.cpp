#include "motion/exact_stop/line_move.h"

#include <algorithm>
#include <cmath>

#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"
#include "motion/path/orientation_path.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

JointRole master_role(const JointChanges& changes) {
    if (changes.norm(JointRole::position) > 0) return JointRole::position;
    if (changes.norm(JointRole::secondary) > 0) return JointRole::secondary;
    return JointRole::rotary;
}

MasterPath line_master_path(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                            JointRole role) {
    MasterPath master{.length = changes.norm(role)};
    if (role == JointRole::rotary) {
        master.limit_speed(rules.orientation_speed_rad_s, {LimitKind::feed, -1});
        master.limit_acceleration(rules.orientation_acceleration_rad_s2, {LimitKind::path_acceleration, -1});
        master.limit_deceleration(rules.orientation_acceleration_rad_s2);
    } else {
        limit_by_path(rules, master);
    }
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.of(joint) == 0 || changes.role(joint) != role) continue;
        master.limit_by_joint(joint, law_limits(setup, joint), std::abs(changes.of(joint)) / master.length);
    }
    return master;
}

/// Along a great circle the angle of the tool's direction is the master if nothing else moves.
MasterPath make_master_path(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                            JointRole role, const OrientationArc* orientation) {
    if (orientation == nullptr) return line_master_path(setup, rules, changes, role);
    MasterPath master{.length = orientation->length_rad()};
    if (role != JointRole::rotary) master = line_master_path(setup, rules, changes, role);
    limit_by_orientation(setup, rules, *orientation, master);
    return master;
}

}  // namespace

PlanResult plan_line(const PlannerSetup& setup, const MoveRules& rules, Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    const JointRole role = master_role(changes);
    segment.kind = SegmentKind::linear;
    if (changes.norm(role) == 0) {
        plan_standstill(segment, 0);
        return {};
    }
    const bool turns = changes.norm(JointRole::rotary) > 0;
    const MoveRules with_dominance = rules.with_dominance(turns && role != JointRole::rotary);
    if (role != JointRole::rotary && with_dominance.programmed_speed_mm_s <= 0)
        return no_programmed_speed_error();
    const OrientationArc* orientation = segment.orientation.get();
    segment.length_mm = role == JointRole::rotary ? 0 : changes.norm(role);
    return set_timing_with_other_joints(setup, with_dominance, changes, role,
                                        make_master_path(setup, with_dominance, changes, role, orientation),
                                        segment);
}

void plan_standstill(Segment& segment, double duration_s) {
    segment.length_mm = 0;
    segment.duration_s = duration_s;
    segment.master = TimeLaw();
    segment.master_limits = {};
}

tl::unexpected<PlanError> no_programmed_speed_error() {
    return make_plan_error(
        rrs::Status::RRS_ZERO_SPEED,
        "No speed is programmed for this motion; set one with SetCartesianPositionSpeed first.");
}

}  // namespace gsim::motion
