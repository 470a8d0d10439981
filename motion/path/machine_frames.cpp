#include "motion/path/machine_frames.h"

namespace gsim::motion {

MachineFrames::MachineFrames(const kinematics::Chain& chain)
    : chain_tool_(chain.tool_side().end),
      chain_base_(chain.tool_side().base),
      work_(chain.work_side().base * chain.work_side().end),
      work_is_carried_(!chain.work_side().links.empty()),
      tool_(chain_tool_),
      base_(chain_base_) {}

void MachineFrames::set(std::string_view name, const rrs::CartPos& pose) {
    if (name == kToolFrame) {
        tool_ = pose;
        tool_shift_ = chain_tool_.inverse() * pose;
    } else {
        base_ = pose;
        base_shift_ = pose * chain_base_.inverse();
    }
}

WorkFrames MachineFrames::work_frames() const {
    if (work_is_carried_) return {.tool = tool_shift_};
    return {.tool = tool_shift_, .object = work_.inverse() * base_shift_.inverse() * work_};
}

}  // namespace gsim::motion
