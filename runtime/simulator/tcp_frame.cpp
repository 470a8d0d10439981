#include "runtime/simulator/tcp_frame.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "motion/path/axis_space.h"
#include "motion/path/tool_path.h"

namespace gsim::simulation {

namespace {

constexpr double kOrthogonalityTolerance = 1e-9;
constexpr double kMaxAlignmentError = 0.01;  // half a degree: no machine that is aligned is off by so much

double non_orthogonality(const Eigen::Matrix3d& directions) {
    return (directions.transpose() * directions - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

/// Returns square directions for a machine with slides that are not quite square: X as it is, Y in the plane
/// of both. A controller that knows the true directions of its slides expects programs written so.
Eigen::Matrix3d orthogonalized(const Eigen::Matrix3d& directions) {
    Eigen::Matrix3d square;
    square.col(0) = directions.col(0).normalized();
    square.col(1) = (directions.col(1) - directions.col(1).dot(square.col(0)) * square.col(0)).normalized();
    square.col(2) = square.col(0).cross(square.col(1)) * (directions.determinant() < 0 ? -1 : 1);
    return square;
}

}  // namespace

tl::expected<TcpFrame, std::string> TcpFrame::make(const motion::PlannerSetup& setup,
                                                   const rrs::JointPos& zero, const Eigen::Vector3d& tool_mm,
                                                   const Eigen::Vector3d& offset_mm) {
    rrs::JointPos joints = zero;
    motion::write_position(setup.position_joints, Eigen::Vector3d::Zero(), joints);
    const rrs::CartPos origin = setup.kinematics->forward(joints);
    TcpFrame frame;
    frame.origin_mm_ = origin * tool_mm;
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) {
            return tl::unexpected(std::string(
                "TCP control needs the linear axes X, Y and Z; this machine does not have all of them"));
        }
        rrs::JointPos moved = joints;
        moved[joint] += 1;
        frame.directions_.col(axis) = setup.kinematics->forward(moved) * tool_mm - frame.origin_mm_;
    }
    const double deviation = non_orthogonality(frame.directions_);
    if (deviation > kOrthogonalityTolerance && deviation < kMaxAlignmentError)
        frame.directions_ = orthogonalized(frame.directions_);
    if (!(deviation < kMaxAlignmentError)) {
        return tl::unexpected(
            std::string("TCP control needs X, Y and Z at right angles; those of this machine are not"));
    }
    frame.handedness_ = frame.directions_.determinant() < 0 ? -1 : 1;
    frame.tcp_mm_ = tool_mm - (origin.linear().transpose() * (frame.directions_ * offset_mm));
    return frame;
}

tl::expected<rrs::JointPos, std::string> TcpFrame::joints(const motion::PlannerSetup& setup,
                                                          const rrs::JointPos& coordinates) const {
    const Eigen::Vector3d requested = point(motion::read_position(setup, coordinates));
    if (auto placed = motion::solve_slides(setup, coordinates, tcp_mm_, requested)) return *std::move(placed);
    return tl::unexpected(std::string("the position of the rotary axes would make two linear axes parallel"));
}

rrs::JointPos TcpFrame::coordinates(const motion::PlannerSetup& setup, const rrs::JointPos& joints) const {
    rrs::JointPos coordinates = joints;
    const Eigen::Vector3d tcp = setup.kinematics->forward(joints) * tcp_mm_;
    motion::write_position(setup.position_joints, directions_.transpose() * (tcp - origin_mm_), coordinates);
    return coordinates;
}

}  // namespace gsim::simulation
