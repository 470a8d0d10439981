#include "collision/cell/frame_tree.h"

#include <utility>

#include "motion/kinematics/chain.h"

namespace gsim::cell {

FrameTree::FrameTree(const machine::Machine& machine) {
    const auto kinematics = machine::make_kinematics(machine);
    const kinematics::Chain& chain = kinematics->chain();
    frames_.reserve(machine.axes.size() + 4);
    insert({"world", 0, rrs::CartPos::Identity(), 0, true});
    base_ = add("base", 0, chain.tool_side().base);
    const std::size_t first_axis_frame = frames_.size();
    for (const machine::Axis& axis : machine.axes) {
        const std::size_t frame = frames_.size();
        const int link = static_cast<int>(frame - first_axis_frame) + 1;
        insert({std::string(1, axis.letter), frame, rrs::CartPos::Identity(), link, true});
    }
    const auto last_link_frame = [&](const kinematics::Branch& branch) {
        return first_axis_frame + static_cast<std::size_t>(branch.links.back().joint);
    };
    const kinematics::Branch& tool_side = chain.tool_side();
    add("tool", tool_side.links.empty() ? base_ : last_link_frame(tool_side), tool_side.end);
    const kinematics::Branch& work_side = chain.work_side();
    if (work_side.links.empty()) {
        add("work", 0, work_side.base * work_side.end);
    } else {
        add("work", last_link_frame(work_side), work_side.end);
    }
    machine_frames_ = frames_.size();
    machine_links_ = static_cast<int>(machine.axes.size()) + 1;
}

std::optional<std::size_t> FrameTree::find(std::string_view name) const {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return std::nullopt;
    return found->second;
}

void FrameTree::insert(Frame frame) {
    by_name_.emplace(frame.name, frames_.size());
    frames_.push_back(std::move(frame));
}

std::size_t FrameTree::add(std::string name, std::size_t parent, const rrs::CartPos& pose_in_parent) {
    insert({std::move(name), parent, pose_in_parent, frames_[parent].link});
    return frames_.size() - 1;
}

rrs::CartPos FrameTree::pose_in_link(std::size_t frame) const {
    rrs::CartPos pose = rrs::CartPos::Identity();
    for (; !frames_[frame].is_link; frame = frames_[frame].parent)
        pose = frames_[frame].pose_in_parent * pose;
    return pose;
}

// Frames that are attached to a frame follow it.
void FrameTree::make_movable(std::size_t frame) {
    frames_[frame].is_link = true;
    int link = machine_links_;
    for (std::size_t i = machine_frames_; i < frames_.size(); ++i)
        frames_[i].link = frames_[i].is_link ? link++ : frames_[frames_[i].parent].link;
}

std::vector<std::string_view> FrameTree::names() const {
    std::vector<std::string_view> names;
    names.reserve(frames_.size());
    for (const Frame& frame : frames_) names.emplace_back(frame.name);
    return names;
}

rrs::CartPos FrameTree::pose_in_world(std::size_t frame, const LinkFrames& links) const {
    return links[static_cast<std::size_t>(link(frame))] * pose_in_link(frame);
}

}  // namespace gsim::cell
