#include "motion/kinematics/screws.h"

namespace gsim::kinematics {

namespace {

Screw make_screw(const Link& link, const std::vector<rrs::CartPos>& joint_frames, double sense) {
    const rrs::CartPos& frame = joint_frames[static_cast<std::size_t>(link.joint)];
    return {.joint = link.joint,
            .kind = link.kind,
            .direction = sense * frame.linear().col(2),
            .point = frame.translation()};
}

}  // namespace

ScrewChain screw_chain(const Chain& chain) {
    const rrs::JointPos zero = rrs::JointPos::Zero(chain.joint_count());
    const std::vector<rrs::CartPos> joint_frames = chain.joint_frames(zero);
    ScrewChain result{.screws = {},
                      .work_at_zero = chain.work_frames(zero).back(),
                      .tool_at_zero = chain.tool_frames(zero).back()};
    result.screws.reserve(joint_frames.size());
    const std::vector<Link>& work = chain.work_side().links;
    for (auto link = work.rbegin(); link != work.rend(); ++link)
        result.screws.push_back(make_screw(*link, joint_frames, -1));
    for (const Link& link : chain.tool_side().links)
        result.screws.push_back(make_screw(link, joint_frames, 1));
    return result;
}

}  // namespace gsim::kinematics
