#include "motion/path/cell_frames.h"

namespace gsim::motion {

rrs::CartPos WorkFrames::target_of(const rrs::CartPos& tool_centre) const {
    return object.inverse() * tool_centre * tool;
}

rrs::CartPos WorkFrames::tool_centre_of(const rrs::CartPos& target) const {
    return object * target * tool.inverse();
}

}  // namespace gsim::motion
