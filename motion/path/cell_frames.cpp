#include "motion/path/cell_frames.h"

namespace gsim::motion {

rrs::CartPos WorkFrames::to_target(const rrs::CartPos& tcp_pose) const {
    return object.inverse() * tcp_pose * tool;
}

rrs::CartPos WorkFrames::to_tool_centre(const rrs::CartPos& target) const {
    return object * target * tool.inverse();
}

}  // namespace gsim::motion
