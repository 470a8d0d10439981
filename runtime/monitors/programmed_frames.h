#pragma once

#include <cstddef>
#include <string_view>

#include <tl/expected.hpp>

#include "collision/cell/frame_tree.h"
#include "motion/path/machine_frames.h"

namespace gsim::simulation {

/// Frames of a cell as the program has set them so far; segments that are still to come may precede them.
/// Errors are those of services that name a frame.
class ProgrammedFrames {
  public:
    ProgrammedFrames(cell::FrameTree frames, motion::MachineFrames machine_frames);

    cell::FrameTree& tree() { return frames_; }
    const cell::FrameTree& tree() const { return frames_; }
    /// Returns the machine's own frames. In the trees "tool" is the file's: another tool tip moves no body.
    motion::MachineFrames& machine_frames() { return machine_frames_; }
    const motion::MachineFrames& machine_frames() const { return machine_frames_; }

    /// Returns the index of the frame of this name.
    tl::expected<std::size_t, motion::PlanError> find(std::string_view name) const;
    /// Returns the frames of targets. Targets lead the tool centre point in the work frame, so a frame that
    /// moves independently against one of them is an error.
    tl::expected<motion::WorkFrames, motion::PlanError> work_frames(std::string_view tool_frame,
                                                                    std::string_view object_frame) const;

  private:
    tl::expected<rrs::CartPos, motion::PlanError> tcp_frame(std::string_view name) const;
    tl::expected<rrs::CartPos, motion::PlanError> object_frame(std::string_view name) const;
    motion::PlanResult check_same_link(std::size_t frame, std::size_t origin) const;

    cell::FrameTree frames_;
    motion::MachineFrames machine_frames_;
};

}  // namespace gsim::simulation
