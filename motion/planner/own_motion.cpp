#include "motion/planner/own_motion.h"

#include <cmath>
#include <memory>
#include <utility>

#include "motion/path/lead_path.h"
#include "motion/profile/law_cut.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

tl::expected<OwnMotion, PlanError> OwnMotion::plan(const PlannerSetup& setup, const rrs::JointPos& start,
                                                   const rrs::JointPos& end, double start_s) {
    OwnMotion motion;
    motion.start_s_ = start_s;
    motion.way_ = end - start;
    LeadPath lead;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (!motion.moves(joint)) continue;
        lead.length = 1;
        lead.limit_by_joint(joint, law_limits(setup, joint), std::abs(motion.way_[joint]));
    }
    if (lead.length == 0) return motion;
    Segment timed;
    if (Planned planned = set_timing(timed, lead, nullptr, 0); !planned)
        return tl::unexpected(std::move(planned.error()));
    motion.law_ = timed.lead;
    return motion;
}

void OwnMotion::carry(Segment& segment) const {
    if (segment.start_s >= end_s()) return;
    const double from_s = segment.start_s - start_s_;
    const rrs::JointPos to_go = left(segment.start_s);
    segment.start += to_go;
    segment.end += to_go;
    if (!(segment.duration_s > 0)) return;
    auto own = std::make_shared<Segment>();
    own->kind = SegmentKind::linear;
    own->duration_s = segment.duration_s;
    own->lead = law_from(law_, from_s);
    own->lead = own->lead.duration_s() > segment.duration_s ? law_until(own->lead, segment.duration_s)
                                                            : law_and_rest(own->lead, segment.duration_s);
    own->start = rrs::JointPos::Zero(way_.size());
    own->end = own->lead.length() * way_;
    own->position_joints = segment.position_joints;
    segment.beside = std::move(own);
}

rrs::JointPos OwnMotion::left(double time_s) const {
    return (law_.at(time_s - start_s_).s - law_.length()) * way_;
}

}  // namespace gsim::motion
