#include "motion/exact_stop/line_move.h"

#include <algorithm>
#include <cmath>

#include "motion/path/joint_changes.h"
#include "motion/path/lead_path.h"
#include "motion/path/orientation_path.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

JointRole leading_role(const JointChanges& changes) {
    if (changes.norm(JointRole::position) > 0) return JointRole::position;
    if (changes.norm(JointRole::secondary) > 0) return JointRole::secondary;
    return JointRole::rotary;
}

LeadPath straight_path(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                       JointRole role) {
    LeadPath lead{.length = changes.norm(role)};
    if (role == JointRole::rotary) {
        lead.limit_speed(rules.orientation_speed_rad_s, {LimitKind::feed, -1});
        lead.limit_acceleration(rules.orientation_acceleration_rad_s2, {LimitKind::path_acceleration, -1});
        lead.limit_deceleration(rules.orientation_acceleration_rad_s2);
    } else {
        limit_by_path(rules, lead);
    }
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.of(joint) == 0 || changes.role(joint) != role) continue;
        lead.limit_by_joint(joint, law_limits(setup, joint), std::abs(changes.of(joint)) / lead.length);
    }
    return lead;
}

/// Along a great circle the angle of the tool's direction is the master if nothing else moves.
LeadPath leading_path(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                      JointRole role, const OrientationArc* orientation) {
    if (orientation == nullptr) return straight_path(setup, rules, changes, role);
    LeadPath lead{.length = orientation->length_rad()};
    if (role != JointRole::rotary) lead = straight_path(setup, rules, changes, role);
    limit_by_orientation(setup, rules, *orientation, lead);
    return lead;
}

}  // namespace

Planned plan_line(const PlannerSetup& setup, const MoveRules& rules, Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    const JointRole role = leading_role(changes);
    segment.kind = SegmentKind::linear;
    if (changes.norm(role) == 0) {
        plan_stay(segment, 0);
        return {};
    }
    const bool turns = changes.norm(JointRole::rotary) > 0;
    const MoveRules resolved = rules.resolved(turns && role != JointRole::rotary);
    if (role != JointRole::rotary && resolved.programmed_speed_mm_s <= 0) return no_programmed_speed();
    const OrientationArc* orientation = segment.orientation.get();
    segment.length_mm = role == JointRole::rotary ? 0 : changes.norm(role);
    return set_timing_with_beside(setup, resolved, changes, role,
                                  leading_path(setup, resolved, changes, role, orientation), segment);
}

void plan_stay(Segment& segment, double duration_s) {
    segment.length_mm = 0;
    segment.duration_s = duration_s;
    segment.lead = TimeLaw();
    segment.lead_limits = {};
}

tl::unexpected<PlanError> no_programmed_speed() {
    return refused(rrs::Status::RRS_ZERO_SPEED,
                   "No speed is programmed for this motion; set one with SetCartesianPositionSpeed first.");
}

}  // namespace gsim::motion
