#pragma once

#include <string_view>

#include "motion/kinematics/chain.h"
#include "motion/path/cell_frames.h"

namespace gsim::motion {

inline constexpr std::string_view kToolFrame = "tool";
inline constexpr std::string_view kBaseFrame = "base";

/// The two frames of a machine that programs may change (ModifyCellFrame): its TCP in the frame of the last
/// joint before it, and its base in the world. They begin as in the machine's chain, from which joint values
/// are always computed. The complete machine moves with the base; a work frame that no joints carry keeps its
/// position.
class MachineFrames {
  public:
    explicit MachineFrames(const kinematics::Chain& chain);

    static bool has(std::string_view name) { return name == kToolFrame || name == kBaseFrame; }
    /// Sets a frame; `name` is one of the two.
    void set(std::string_view name, const rrs::CartPos& pose);
    const rrs::CartPos& tool() const { return tool_; }
    const rrs::CartPos& base() const { return base_; }

    /// Returns the TCP in that of the chain.
    const rrs::CartPos& tool_shift() const { return tool_shift_; }
    /// Returns how the machine has been moved in the world.
    const rrs::CartPos& base_shift() const { return base_shift_; }
    /// Returns the frames of targets without another selection.
    WorkFrames work_frames() const;

  private:
    rrs::CartPos chain_tool_;
    rrs::CartPos chain_base_;
    rrs::CartPos work_;  ///< In the world.
    bool work_is_carried_;
    rrs::CartPos tool_;
    rrs::CartPos base_;
    rrs::CartPos tool_shift_ = rrs::CartPos::Identity();
    rrs::CartPos base_shift_ = rrs::CartPos::Identity();
};

}  // namespace gsim::motion
