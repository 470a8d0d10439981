#include "runtime/cell/frame_tree.h"

#include <algorithm>
#include <utility>

#include "runtime/kinematics/dh_chain.h"

namespace gsim::cell {

FrameTree::FrameTree(const machine::Machine& machine) {
    const auto kinematics = machine::make_kinematics(machine);
    const kinematics::DhChain& chain = kinematics->chain();
    frames_.reserve(machine.axes.size() + 3);
    frames_.push_back({"world", 0, rrs::CartPos::Identity(), 0});
    add("base", 0, chain.base());
    std::size_t last = 1;
    for (const machine::Axis& axis : machine.axes) {
        last = frames_.size();
        const int link = static_cast<int>(last) - 1;
        frames_.push_back({std::string(1, axis.letter), last, rrs::CartPos::Identity(), link});
    }
    add("tool", last, chain.tool());
    machine_frames_ = frames_.size();
}

std::optional<std::size_t> FrameTree::find(std::string_view name) const {
    const auto frame =
        std::find_if(frames_.begin(), frames_.end(), [name](const Frame& f) { return f.name == name; });
    if (frame == frames_.end()) return std::nullopt;
    return static_cast<std::size_t>(frame - frames_.begin());
}

std::size_t FrameTree::add(std::string name, std::size_t parent, const rrs::CartPos& in_parent) {
    frames_.push_back({std::move(name), parent, in_parent, frames_[parent].link});
    return frames_.size() - 1;
}

rrs::CartPos FrameTree::in_link(std::size_t frame) const {
    rrs::CartPos pose = frames_[frame].in_parent;
    while (frames_[frame].parent != frame) {
        frame = frames_[frame].parent;
        pose = frames_[frame].in_parent * pose;
    }
    return pose;
}

std::vector<std::string_view> FrameTree::names() const {
    std::vector<std::string_view> names;
    names.reserve(frames_.size());
    for (const Frame& frame : frames_) names.emplace_back(frame.name);
    return names;
}

}  // namespace gsim::cell
