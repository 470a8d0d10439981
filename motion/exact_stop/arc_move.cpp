#include "motion/exact_stop/arc_move.h"

#include "motion/exact_stop/line_move.h"
#include "motion/path/arc_limits.h"
#include "motion/path/joint_changes.h"
#include "motion/path/lead_path.h"
#include "motion/path/orientation_path.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

LeadPath arc_path(const PlannerSetup& setup, const MoveRules& rules, const Segment& segment) {
    LeadPath lead{.length = segment.length_mm};
    limit_by_path(rules, lead);
    const Eigen::Vector3d shares = segment.arc.max_shares();
    for (int axis = 0; axis < 3; ++axis) {
        const double share = shares[axis];
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0 || share < kNoShare) continue;
        lead.limit_by_joint(joint, law_limits(setup, joint), share);
    }
    return lead;
}

bool leaves_the_machine(const PlannerSetup& setup, const Arc& arc) {
    for (int axis = 0; axis < 3; ++axis) {
        if (setup.position_joints[static_cast<std::size_t>(axis)] < 0 && arc.max_share(axis) > kNoShare)
            return true;
    }
    return false;
}

}  // namespace

Planned check_arc(const PlannerSetup& setup, const Arc& arc) {
    if (leaves_the_machine(setup, arc)) {
        return refused(rrs::Status::RRS_INVALID_PARAMETER,
                       "The arc needs a direction in which the machine has no joint.");
    }
    return {};
}

Planned plan_arc(const PlannerSetup& setup, const MoveRules& rules, Segment& segment) {
    if (Planned checked = check_arc(setup, segment.arc); !checked) return checked;
    segment.kind = SegmentKind::circular;
    segment.length_mm = segment.arc.length_mm();
    const JointChanges changes(setup, segment.start, segment.end);
    const MoveRules resolved = rules.resolved(changes.norm(JointRole::rotary) > 0);
    if (resolved.programmed_speed_mm_s <= 0) return no_programmed_speed();
    const OrientationArc* orientation = segment.orientation.get();
    LeadPath lead = arc_path(setup, resolved, segment);
    limit_by_arc_jerk(setup, segment.arc, lead);
    if (orientation != nullptr) limit_by_orientation(setup, resolved, *orientation, lead);
    return set_timing_with_beside(setup, resolved, changes, JointRole::position, lead, segment);
}

}  // namespace gsim::motion
