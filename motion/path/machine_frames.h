#pragma once

#include <string_view>

#include "motion/kinematics/chain.h"
#include "motion/path/cell_frames.h"

namespace gsim::motion {

inline constexpr std::string_view kToolFrame = "tool";
inline constexpr std::string_view kBaseFrame = "base";

/// The two frames of a machine that programs may change (ModifyCellFrame): its tool centre point in the frame
/// of the last joint in front of it, and its base in the world. At first they are as the machine's chain has
/// them, by which joint values are worked out all along. With the base the whole machine moves; a work frame
/// that no joints carry stays where it is.
class MachineFrames {
  public:
    explicit MachineFrames(const kinematics::Chain& chain);

    static bool has(std::string_view name) { return name == kToolFrame || name == kBaseFrame; }
    /// `name` is one of the two.
    void set(std::string_view name, const rrs::CartPos& pose);
    const rrs::CartPos& tool() const { return tool_; }
    const rrs::CartPos& base() const { return base_; }

    /// The tool centre point in that of the chain.
    const rrs::CartPos& tool_shift() const { return tool_shift_; }
    /// How the machine has been moved in the world.
    const rrs::CartPos& base_shift() const { return base_shift_; }
    /// Of targets for which nothing else is selected.
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
