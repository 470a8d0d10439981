#include "collision/cell/link_frames.h"

#include <algorithm>

#include "motion/kinematics/chain.h"

namespace gsim::cell {

namespace {

void set_links(const kinematics::Branch& branch, const std::vector<rrs::CartPos>& frames, LinkFrames& links) {
    for (std::size_t i = 0; i < branch.links.size(); ++i)
        links[static_cast<std::size_t>(branch.links[i].joint) + 1] = frames[i + 1];
}

}  // namespace

LinkFrames link_frames(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints) {
    const kinematics::Chain& chain = kinematics.chain();
    LinkFrames links(static_cast<std::size_t>(chain.joint_count()) + 1, rrs::CartPos::Identity());
    set_links(chain.tool_side(), chain.tool_frames(joints), links);
    if (!chain.work_side().links.empty()) set_links(chain.work_side(), chain.work_frames(joints), links);
    return links;
}

std::vector<JointAxis> joint_axes(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints) {
    const kinematics::Chain& chain = kinematics.chain();
    std::vector<JointAxis> axes;
    axes.reserve(static_cast<std::size_t>(chain.joint_count()));
    int joint = 0;
    for (const rrs::CartPos& frame : chain.joint_frames(joints))
        axes.push_back({chain.kind(joint++), frame.translation(), frame.linear().col(2)});
    return axes;
}

std::vector<int> joints_to(const kinematics::Kinematics& kinematics, int link, std::span<const int> parents) {
    const kinematics::Chain& chain = kinematics.chain();
    if (const int frame_index = link - chain.joint_count() - 1; frame_index >= 0) {
        std::vector<int> joints =
            joints_to(kinematics, parents[static_cast<std::size_t>(frame_index)], parents);
        const int slide = chain.joint_count() + 2 * frame_index;
        joints.insert(joints.end(), {slide, slide + 1});
        return joints;
    }
    for (const kinematics::Branch* branch : {&chain.tool_side(), &chain.work_side()}) {
        std::vector<int> joints;
        joints.reserve(branch->links.size());
        for (const kinematics::Link& of : branch->links) {
            joints.push_back(of.joint);
            if (of.joint == link - 1) return joints;
        }
    }
    return {};
}

std::vector<int> joints_between(const kinematics::Kinematics& kinematics, int first, int second,
                                std::span<const int> parents) {
    const std::vector<int> joints_to_first = joints_to(kinematics, first, parents);
    const std::vector<int> joints_to_second = joints_to(kinematics, second, parents);
    const auto [frame_index, other] = std::mismatch(joints_to_first.begin(), joints_to_first.end(),
                                                    joints_to_second.begin(), joints_to_second.end());
    std::vector<int> joints(std::make_reverse_iterator(joints_to_first.end()),
                            std::make_reverse_iterator(frame_index));
    joints.insert(joints.end(), other, joints_to_second.end());
    return joints;
}

}  // namespace gsim::cell
