#include "runtime/cell/link_frames.h"

#include "runtime/kinematics/dh_chain.h"

namespace gsim::cell {

LinkFrames link_frames(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints) {
    LinkFrames frames = kinematics.chain().frames(joints);
    frames.front() = rrs::CartPos::Identity();
    frames.pop_back();  // the tool, which is fixed to the last link
    return frames;
}

JointAxis joint_axis(const kinematics::Kinematics& kinematics, const LinkFrames& links, int joint) {
    const rrs::CartPos& before =
        joint == 0 ? kinematics.chain().base() : links[static_cast<std::size_t>(joint)];
    return {kinematics.chain().kind(joint), before.translation(), before.linear().col(2)};
}

}  // namespace gsim::cell
