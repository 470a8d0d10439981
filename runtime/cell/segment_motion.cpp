#include "runtime/cell/segment_motion.h"

#include "runtime/cell/joint_travel.h"

namespace gsim::cell {

MotionPart SegmentMotion::part(double from_s, const LinkFrames& from, double to_s,
                               const LinkFrames& to) const {
    std::vector<JointAxis> axes = joint_axes(kinematics_, segment_.position_at(from_s));
    return {from_s, to_s, from, to, ChainMotion(std::move(axes), travel_of(segment_, from_s, to_s))};
}

}  // namespace gsim::cell
