#include "analysis/envelope/nearest_reach.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "motion/kinematics/dense.h"

namespace gsim::envelope {

namespace {

constexpr int kSteps = 30;
constexpr double kLeastWay_mm = 1e-9;
constexpr double kFirstDamping = 1e-3;

using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, rrs::kMaxJoints>;

/// TCP, and its motion with each joint.
struct Tip {
    Vector3d place;
    Columns jacobian;
};

// Runs from the last joint to the first: each one moves the TCP, and the motion that later joints give it.
Tip tip_at(const TipChain& chain, const rrs::JointPos& values) {
    Tip tip{chain.start_mm, Columns(3, values.size())};
    for (Eigen::Index i = values.size(); i-- > 0;) {
        const TipJoint& joint = chain.joints[static_cast<std::size_t>(i)];
        tip.place = joint.moved(tip.place, values[i]);
        if (joint.is_slide()) {
            tip.jacobian.col(i) = joint.direction;
            continue;
        }
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(values[i], joint.direction).toRotationMatrix();
        tip.jacobian.col(i) = joint.direction.cross(tip.place - joint.point_mm);
        const Eigen::Index behind = values.size() - i - 1;
        tip.jacobian.rightCols(behind) = (turn * tip.jacobian.rightCols(behind)).eval();
    }
    return tip;
}

// Holds a joint at an end if it would move on beyond it.
rrs::JointPos step(const TipChain& chain, const rrs::JointPos& values, const Tip& tip, const Vector3d& left,
                   double damping) {
    Columns columns = tip.jacobian;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const TipJoint& joint = chain.joints[static_cast<std::size_t>(i)];
        const double pull = columns.col(i).dot(left);
        if ((values[i] <= joint.low && pull < 0) || (values[i] >= joint.high && pull > 0))
            columns.col(i).setZero();
    }
    // Avoids Eigen's product of large matrices, because it costs a second of each build and these are small.
    kinematics::JointSquare normal = columns.transpose().lazyProduct(columns);
    const rrs::JointPos sizes = normal.diagonal();
    normal.diagonal() += damping * sizes + rrs::JointPos::Constant(values.size(), 1e-12);
    rrs::JointPos next = values + kinematics::solve_symmetric(normal, columns.transpose().lazyProduct(left));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const TipJoint& joint = chain.joints[static_cast<std::size_t>(i)];
        next[i] = std::clamp(next[i], joint.low, joint.high);
    }
    return next;
}

}  // namespace

Vector3d nearest_reach(const TipChain& chain, const std::vector<double>& from, const Vector3d& target) {
    rrs::JointPos values =
        Eigen::Map<const Eigen::VectorXd>(from.data(), static_cast<Eigen::Index>(from.size()));
    Tip tip = tip_at(chain, values);
    double damping = kFirstDamping;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3d left = target - tip.place;
        const rrs::JointPos next = step(chain, values, tip, left, damping);
        Tip moved = tip_at(chain, next);
        const double gain = left.norm() - (target - moved.place).norm();
        if (gain > 0) {
            values = next;
            tip = std::move(moved);
            damping /= 4;
            if (gain < kLeastWay_mm) break;
        } else {
            damping = std::max(damping, kFirstDamping) * 8;
            if (damping > 1e6) break;
        }
    }
    return tip.place;
}

}  // namespace gsim::envelope
