#include "motion/planner/move.h"

namespace gsim::motion {

rrs::CartPos PoseGoal::tool_centre() const {
    return pose * tool.inverse();
}

}  // namespace gsim::motion
