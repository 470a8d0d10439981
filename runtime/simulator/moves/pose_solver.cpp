#include "runtime/simulator/moves/pose_solver.h"

#include <fmt/format.h>

#include "motion/path/axis_space.h"

namespace gsim::simulation {

motion::WorkFrames PoseSolver::work_frames() const {
    return motion_.source().work_frames().value_or(program_.machine_frames().work_frames());
}

tl::expected<AxisVector, std::string> PoseSolver::solve_axes(const rrs::CartPos& pose,
                                                             const std::vector<GroupTarget>& groups) const {
    rrs::JointPos near = position_.to_joints(position_.axes());
    for (const motion::GroupJoint& one : groups_.joints(groups)) near[one.joint] = one.value;
    return motion_.setup()
        .kinematics->inverse(work_frames().to_tool_centre(pose), near)
        .map([this](const rrs::JointPos& joints) { return position_.to_axes(joints); });
}

bool PoseSolver::rotary_joints_move_tcp() const {
    return motion::rotary_joints_move_tcp(motion_.setup(), work_frames().tcp_mm());
}

void PoseSolver::warn_if_singular(const AxisVector& axes, const SourceLocation& location) {
    const std::vector<int> joints = motion_.setup().kinematics->aligned_joints(position_.to_joints(axes));
    if (joints.empty()) return;
    std::string letters;
    for (const int joint : joints) {
        if (!letters.empty()) letters += " and ";
        letters += machine_.axes[static_cast<std::size_t>(joint)].letter;
    }
    warnings_.add(fmt::format(
        "{}the pose is singular: axes {} are aligned and can turn against each other without moving the tool",
        program_.files().prefix(location), letters));
}

}  // namespace gsim::simulation
