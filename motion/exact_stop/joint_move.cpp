#include "motion/exact_stop/joint_move.h"

#include <cmath>

#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/lead_path.h"

namespace gsim::motion {

Planned plan_joint_move(const PlannerSetup& setup, const MoveTerms& terms, double speed_share,
                        Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    segment.kind = SegmentKind::joint;
    LeadPath lead;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(changes.of(joint));
        if (change == 0) continue;
        lead.length = 1;
        lead.limit_by_joint(joint, terms.joint_limits(setup, joint, speed_share), change);
    }
    if (lead.length == 0) {
        plan_stay(segment, 0);
        return {};
    }
    segment.length_mm = changes.norm(JointRole::position);
    return set_timing(segment, lead, nullptr, terms.motion_time_s / speed_share);
}

}  // namespace gsim::motion
