#include "motion/kinematics/jacobian.h"

#include <algorithm>
#include <cmath>

#include "base/dense/singular.h"

namespace gsim::kinematics {

namespace {

using Eigen::Vector3d;

constexpr double kMinParticipation =
    0.05;  // share of the greatest part from which a joint counts as taking part

void add_columns(const Branch& branch, const std::vector<rrs::CartPos>& frames, const Vector3d& tcp,
                 double sense, Jacobian& jacobian) {
    for (const Link& link : branch.links) {
        const rrs::CartPos& frame = frames[static_cast<std::size_t>(link.joint)];
        const Vector3d axis = sense * frame.linear().col(2);
        if (link.kind == rrs::JointKind::prismatic) {
            jacobian.col(link.joint) << axis, Vector3d::Zero();
        } else {
            jacobian.col(link.joint) << axis.cross(tcp - frame.translation()), axis;
        }
    }
}

// Returns the rotation vector of a matrix, also near half a turn, at which the antisymmetric part vanishes.
Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
    const Eigen::Quaterniond q(rotation);
    const double sine = q.vec().norm();
    if (sine < 1e-150) return Vector3d::Zero();
    const double half = std::atan2(sine, std::abs(q.w()));
    return q.vec() * (2 * half / sine * (q.w() < 0 ? -1 : 1));
}

}  // namespace

Configuration configuration(const Chain& chain, const rrs::JointPos& joints) {
    Configuration result{.tool = chain.tool_frames(joints).back(),
                         .work = chain.work_frames(joints).back(),
                         .jacobian = Jacobian::Zero(6, chain.joint_count())};
    const std::vector<rrs::CartPos> frames = chain.joint_frames(joints);
    const Vector3d tcp = result.tool.translation();
    add_columns(chain.tool_side(), frames, tcp, 1, result.jacobian);
    add_columns(chain.work_side(), frames, tcp, -1, result.jacobian);
    return result;
}

Twist twist_to_pose(const Configuration& configuration, const rrs::CartPos& pose) {
    const rrs::CartPos target = configuration.work * pose;
    Twist twist;
    twist << target.translation() - configuration.tool.translation(),
        rotation_vector(target.linear() * configuration.tool.linear().transpose());
    return twist;
}

double mm_per_rad(const Chain& chain) {
    const rrs::JointPos zero = rrs::JointPos::Zero(chain.joint_count());
    double reach_mm = 0;
    for (const auto& frames : {chain.tool_frames(zero), chain.work_frames(zero)}) {
        for (std::size_t i = 2; i < frames.size(); ++i)
            reach_mm += (frames[i].translation() - frames[i - 1].translation()).norm();
    }
    return std::isfinite(reach_mm) ? std::max(1.0, reach_mm) : 1.0;
}

std::vector<int> aligned_joints(const Configuration& configuration, double mm_per_rad, double threshold) {
    Eigen::MatrixXd scaled = configuration.jacobian;
    scaled.topRows<3>() /= mm_per_rad;
    for (Eigen::Index joint = 0; joint < scaled.cols(); ++joint) {
        if (scaled.col(joint).tail<3>().isZero(0)) scaled.col(joint) *= mm_per_rad;
    }
    const base::SingularValues singular = base::singular_values(scaled);
    const Eigen::Index last = singular.values.size() - 1;
    std::vector<int> joints;
    if (last < 0 || singular.values[last] >= threshold) return joints;
    const Eigen::VectorXd parts = singular.right.col(last).cwiseAbs();
    for (Eigen::Index joint = 0; joint < parts.size(); ++joint) {
        if (parts[joint] > kMinParticipation * parts.maxCoeff()) joints.push_back(static_cast<int>(joint));
    }
    return joints;
}

}  // namespace gsim::kinematics
