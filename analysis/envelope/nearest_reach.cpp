#include "analysis/envelope/nearest_reach.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "motion/kinematics/symmetric_solver.h"

namespace gsim::envelope {

namespace {

constexpr int kSteps = 30;
constexpr double kMinProgress_mm = 1e-9;
constexpr double kInitialDamping = 1e-3;

using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, rrs::kMaxJoints>;

/// TCP, and its motion with each joint.
struct TcpState {
    Vector3d position;
    Columns jacobian;
};

// Runs from the last joint to the first: each one moves the TCP, and the motion that later joints give it.
TcpState tcp_at(const TcpChain& chain, const rrs::JointPos& values) {
    TcpState tcp{chain.start_mm, Columns(3, values.size())};
    for (Eigen::Index i = values.size(); i-- > 0;) {
        const TcpJoint& joint = chain.joints[static_cast<std::size_t>(i)];
        tcp.position = joint.transformed(tcp.position, values[i]);
        if (joint.is_slide()) {
            tcp.jacobian.col(i) = joint.direction;
            continue;
        }
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(values[i], joint.direction).toRotationMatrix();
        tcp.jacobian.col(i) = joint.direction.cross(tcp.position - joint.point_mm);
        const Eigen::Index trailing_count = values.size() - i - 1;
        tcp.jacobian.rightCols(trailing_count) = (turn * tcp.jacobian.rightCols(trailing_count)).eval();
    }
    return tcp;
}

// Holds a joint at an end if it would move on beyond it.
rrs::JointPos step(const TcpChain& chain, const rrs::JointPos& values, const TcpState& tcp,
                   const Vector3d& remaining, double damping) {
    Columns columns = tcp.jacobian;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const TcpJoint& joint = chain.joints[static_cast<std::size_t>(i)];
        const double gradient = columns.col(i).dot(remaining);
        if ((values[i] <= joint.low && gradient < 0) || (values[i] >= joint.high && gradient > 0))
            columns.col(i).setZero();
    }
    // Avoids Eigen's product of large matrices, because it costs a second of each build and these are small.
    kinematics::JointMatrix normal = columns.transpose().lazyProduct(columns);
    const rrs::JointPos sizes = normal.diagonal();
    normal.diagonal() += damping * sizes + rrs::JointPos::Constant(values.size(), 1e-12);
    rrs::JointPos next =
        values + kinematics::solve_symmetric(normal, columns.transpose().lazyProduct(remaining));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const TcpJoint& joint = chain.joints[static_cast<std::size_t>(i)];
        next[i] = std::clamp(next[i], joint.low, joint.high);
    }
    return next;
}

}  // namespace

Vector3d nearest_reachable_point(const TcpChain& chain, const std::vector<double>& from,
                                 const Vector3d& target) {
    rrs::JointPos values =
        Eigen::Map<const Eigen::VectorXd>(from.data(), static_cast<Eigen::Index>(from.size()));
    TcpState tcp = tcp_at(chain, values);
    double damping = kInitialDamping;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3d remaining = target - tcp.position;
        const rrs::JointPos next = step(chain, values, tcp, remaining, damping);
        TcpState transformed = tcp_at(chain, next);
        const double gain = remaining.norm() - (target - transformed.position).norm();
        if (gain > 0) {
            values = next;
            tcp = std::move(transformed);
            damping /= 4;
            if (gain < kMinProgress_mm) break;
        } else {
            damping = std::max(damping, kInitialDamping) * 8;
            if (damping > 1e6) break;
        }
    }
    return tcp.position;
}

}  // namespace gsim::envelope
