#include "motion/exact_stop/arc_move.h"

#include "motion/exact_stop/line_move.h"
#include "motion/path/arc_limits.h"
#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"
#include "motion/path/orientation_path.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

namespace {

MasterPath arc_master_path(const PlannerSetup& setup, const MoveRules& rules, const Segment& segment) {
    MasterPath master{.length = segment.length_mm};
    limit_by_path(rules, master);
    const Eigen::Vector3d shares = segment.arc.max_shares();
    for (int axis = 0; axis < 3; ++axis) {
        const double share = shares[axis];
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0 || share < kMinShare) continue;
        master.limit_by_joint(joint, law_limits(setup, joint), share);
    }
    return master;
}

bool needs_missing_joint(const PlannerSetup& setup, const Arc& arc) {
    for (int axis = 0; axis < 3; ++axis) {
        if (setup.position_joints[static_cast<std::size_t>(axis)] < 0 && arc.max_share(axis) > kMinShare)
            return true;
    }
    return false;
}

}  // namespace

PlanResult check_arc(const PlannerSetup& setup, const Arc& arc) {
    if (needs_missing_joint(setup, arc)) {
        return make_plan_error(rrs::Status::RRS_INVALID_PARAMETER,
                               "The arc needs a direction in which the machine has no joint.");
    }
    return {};
}

PlanResult plan_arc(const PlannerSetup& setup, const MoveRules& rules, Segment& segment) {
    if (PlanResult checked = check_arc(setup, segment.arc); !checked) return checked;
    segment.kind = SegmentKind::circular;
    segment.length_mm = segment.arc.length_mm();
    const JointChanges changes(setup, segment.start, segment.end);
    const MoveRules with_dominance = rules.with_dominance(changes.norm(JointRole::rotary) > 0);
    if (with_dominance.programmed_speed_mm_s <= 0) return no_programmed_speed_error();
    const OrientationArc* orientation = segment.orientation.get();
    MasterPath master = arc_master_path(setup, with_dominance, segment);
    limit_by_arc_jerk(setup, segment.arc, master);
    if (orientation != nullptr) limit_by_orientation(setup, with_dominance, *orientation, master);
    return set_timing_with_other_joints(setup, with_dominance, changes, JointRole::position, master, segment);
}

}  // namespace gsim::motion
