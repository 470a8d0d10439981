#include "motion/path/joint_changes.h"

#include <cmath>

namespace gsim::motion {

JointChanges::JointChanges(const PlannerSetup& setup, const rrs::JointPos& start, const rrs::JointPos& end,
                           double min) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const auto index = static_cast<std::size_t>(joint);
        const double change = end[joint] - start[joint];
        roles_[index] = setup.role(joint);
        changes_[index] = std::abs(change) > min ? change : 0;
        norms_[static_cast<std::size_t>(roles_[index])] += changes_[index] * changes_[index];
    }
    for (double& norm : norms_) norm = std::sqrt(norm);
}

}  // namespace gsim::motion
