#include "motion/planner/move.h"

namespace gsim::motion {

rrs::CartPos PoseGoal::tcp_pose() const {
    return pose * tool.inverse();
}

}  // namespace gsim::motion
