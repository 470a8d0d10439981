#include "collision/cell/placed_kinematics.h"

#include "motion/kinematics/chain_kinematics.h"

namespace gsim::cell {

std::shared_ptr<const kinematics::Kinematics> placed_kinematics(
    std::shared_ptr<const kinematics::Kinematics> kinematics, const FrameTree& frames) {
    const kinematics::Chain& chain = kinematics->chain();
    const rrs::CartPos& file_base = chain.tool_side().base;
    const rrs::CartPos& base = frames.pose_in_parent(frames.base());
    if (base.matrix() == file_base.matrix()) return kinematics;
    return std::make_shared<kinematics::ChainKinematics>(moved(chain, base * file_base.inverse()));
}

}  // namespace gsim::cell
