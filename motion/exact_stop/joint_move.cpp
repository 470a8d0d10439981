#include "motion/exact_stop/joint_move.h"

#include <cmath>

#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"

namespace gsim::motion {

PlanResult plan_joint_move(const PlannerSetup& setup, const MoveParameters& move_parameters,
                           double speed_share, Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    segment.kind = SegmentKind::joint;
    MasterPath master;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(changes.of(joint));
        if (change == 0) continue;
        master.length = 1;
        master.limit_by_joint(joint, move_parameters.joint_limits(setup, joint, speed_share), change);
    }
    if (master.length == 0) {
        plan_standstill(segment, 0);
        return {};
    }
    segment.length_mm = changes.norm(JointRole::position);
    return set_timing(segment, master, nullptr, move_parameters.motion_time_s / speed_share);
}

}  // namespace gsim::motion
