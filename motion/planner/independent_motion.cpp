#include "motion/planner/independent_motion.h"

#include <cmath>
#include <memory>
#include <utility>

#include "motion/path/master_path.h"
#include "motion/profile/law_cut.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

tl::expected<IndependentMotion, PlanError> IndependentMotion::plan(const PlannerSetup& setup,
                                                                   const rrs::JointPos& start,
                                                                   const rrs::JointPos& end, double start_s) {
    IndependentMotion motion;
    motion.start_s_ = start_s;
    motion.displacement_ = end - start;
    MasterPath master;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (!motion.moves(joint)) continue;
        master.length = 1;
        master.limit_by_joint(joint, law_limits(setup, joint), std::abs(motion.displacement_[joint]));
    }
    if (master.length == 0) return motion;
    Segment timed;
    if (PlanResult planned = set_timing(timed, master, nullptr, 0); !planned)
        return tl::unexpected(std::move(planned.error()));
    motion.law_ = timed.master;
    return motion;
}

void IndependentMotion::superimpose(Segment& segment) const {
    if (segment.start_s >= end_s()) return;
    const double from_s = segment.start_s - start_s_;
    const rrs::JointPos remaining_joints = remaining(segment.start_s);
    segment.start += remaining_joints;
    segment.end += remaining_joints;
    if (!(segment.duration_s > 0)) return;
    auto independent = std::make_shared<Segment>();
    independent->kind = SegmentKind::linear;
    independent->duration_s = segment.duration_s;
    independent->master = law_from(law_, from_s);
    independent->master = independent->master.duration_s() > segment.duration_s
                              ? law_until(independent->master, segment.duration_s)
                              : extend_with_standstill(independent->master, segment.duration_s);
    independent->start = rrs::JointPos::Zero(displacement_.size());
    independent->end = independent->master.length() * displacement_;
    independent->position_joints = segment.position_joints;
    segment.superimposed = std::move(independent);
}

rrs::JointPos IndependentMotion::remaining(double time_s) const {
    return (law_.at(time_s - start_s_).s - law_.length()) * displacement_;
}

}  // namespace gsim::motion
