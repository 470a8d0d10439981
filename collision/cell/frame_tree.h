#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "collision/cell/link_frames.h"
#include "machine/model/machine.h"

namespace gsim::cell {

/// The named frames of a cell, each attached to another one. Those of the machine come first: "world", "base"
/// (of the joints that carry the tool), a letter for the link that follows each axis, "tool" and "work". Only
/// "base" of these can be moved, and the machine with it (placed_kinematics()).
class FrameTree {
  public:
    explicit FrameTree(const machine::Machine& machine);

    std::optional<std::size_t> find(std::string_view name) const;
    const std::string& name(std::size_t frame) const { return frames_[frame].name; }
    std::size_t base() const { return base_; }
    bool is_machine_frame(std::size_t frame) const { return frame < machine_frames_; }
    /// Adds a frame attached to `parent`, which exists. The name must be new.
    std::size_t add(std::string name, std::size_t parent, const rrs::CartPos& pose_in_parent);

    /// Returns the pose relative to the frame to which it is attached (mm).
    const rrs::CartPos& pose_in_parent(std::size_t frame) const { return frames_[frame].pose_in_parent; }
    /// Moves base(), or a frame that is not the machine's, and with it everything that is attached to it.
    void move(std::size_t frame, const rrs::CartPos& pose_in_parent) {
        frames_[frame].pose_in_parent = pose_in_parent;
    }

    /// Makes a frame that is not the machine's independent from now on, with everything attached to it, as a
    /// separate link. The numbers of such links follow those of the machine, in the order of their frames, so
    /// that each is above that of the link in which it moves.
    void make_movable(std::size_t frame);
    /// Returns the frame to which the frame is attached.
    std::size_t parent(std::size_t frame) const { return frames_[frame].parent; }

    /// Returns the link that the frame moves with, as LinkFrames numbers them.
    int link(std::size_t frame) const { return frames_[frame].link; }
    /// Returns the pose relative to that link.
    rrs::CartPos pose_in_link(std::size_t frame) const;
    rrs::CartPos pose_in_world(std::size_t frame, const LinkFrames& links) const;
    /// Returns the names of the frames, those of the machine first.
    std::vector<std::string_view> names() const;

  private:
    struct Frame {
        std::string name;
        std::size_t parent;
        rrs::CartPos pose_in_parent;
        int link;
        bool is_link = false;  ///< True if the frame is at its link's pose.
    };

    // Hash that lets names be looked up without making strings of them.
    struct NameHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>()(name); }
    };

    void insert(Frame frame);

    std::vector<Frame> frames_;
    std::unordered_map<std::string, std::size_t, NameHash, std::equal_to<>>
        by_name_;  ///< The first of a name.
    std::size_t base_ = 0;
    int machine_links_ = 0;
    std::size_t machine_frames_ = 0;
};

}  // namespace gsim::cell
