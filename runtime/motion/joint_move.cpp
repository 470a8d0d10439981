#include "runtime/motion/joint_move.h"

#include <cmath>

#include "runtime/motion/joint_changes.h"
#include "runtime/motion/lead_path.h"
#include "runtime/motion/line_move.h"

namespace gsim::motion {

Planned plan_joint_move(const PlannerSetup& setup, const Programmed& programmed, Segment& segment) {
    const JointChanges changes(setup, segment.start, segment.end);
    segment.kind = SegmentKind::joint;
    LeadPath lead;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(changes.of(joint));
        if (change == 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        lead.length = 1;
        const auto index = static_cast<std::int8_t>(joint);
        lead.limit_speed(programmed.joint_speed(limits, joint) / change, {LimitKind::joint_speed, index});
        lead.limit_acceleration(programmed.joint_acceleration(limits, joint) / change,
                                {LimitKind::acceleration, index});
    }
    if (lead.length == 0) {
        plan_stay(segment, 0);
        return {};
    }
    segment.length_mm = changes.norm(JointRole::position);
    return set_timing(segment, lead, nullptr, programmed.motion_time_s);
}

}  // namespace gsim::motion
