#include "motion/services/kinematics_services.h"

#include <utility>

#include "motion/kinematics/pose.h"

namespace gsim::motion {

using rrs::Status;

PlanResult KinematicsServices::get_inverse_kinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                                      rrs::JointPos& joints) const {
    if (auto checked = kinematics::check_pose(pose); !checked)
        return make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    if (PlanResult checked = targets_.check_joints(near); !checked) return checked;
    auto solution = machine_.setup().kinematics->inverse(selections_.frames.to_tool_centre(pose), near);
    if (!solution) return make_plan_error(Status::RRS_NO_SOLUTION, std::move(solution.error()));
    joints = *solution;
    return {};
}

PlanResult KinematicsServices::get_forward_kinematics(const rrs::JointPos& joints, rrs::CartPos& pose) const {
    if (PlanResult checked = targets_.check_joints(joints); !checked) return checked;
    pose = selections_.frames.to_target(machine_.setup().kinematics->forward(joints));
    return {};
}

}  // namespace gsim::motion
