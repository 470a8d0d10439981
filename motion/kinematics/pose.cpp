#include "motion/kinematics/pose.h"

#include <cmath>

namespace gsim::kinematics {

namespace {

constexpr double kRotationTolerance = 1e-6;
constexpr double kGimbalLock = 1e-12;  // cosine of the pitch below which roll and yaw are one

}  // namespace

rrs::CartPos pose_from_rpy(const Rpy& rpy) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    rrs::CartPos pose = rrs::CartPos::Identity();
    pose.translation() = Vector3d(rpy.x_mm, rpy.y_mm, rpy.z_mm);
    pose.linear() =
        (AngleAxisd(rpy.roll_rad, Vector3d::UnitZ()) * AngleAxisd(rpy.pitch_rad, Vector3d::UnitY()) *
         AngleAxisd(rpy.yaw_rad, Vector3d::UnitX()))
            .toRotationMatrix();
    return pose;
}

Rpy rpy_from_pose(const rrs::CartPos& pose) {
    const Eigen::Matrix3d r = pose.linear();
    const double cos_pitch = std::hypot(r(0, 0), r(1, 0));
    Rpy rpy{.x_mm = pose.translation().x(), .y_mm = pose.translation().y(), .z_mm = pose.translation().z()};
    rpy.pitch_rad = std::atan2(-r(2, 0), cos_pitch);
    if (cos_pitch > kGimbalLock) {
        rpy.roll_rad = std::atan2(r(1, 0), r(0, 0));
        rpy.yaw_rad = std::atan2(r(2, 1), r(2, 2));
    } else {
        rpy.roll_rad = std::atan2(-r(0, 1), r(1, 1));
    }
    return rpy;
}

tl::expected<void, std::string> check_pose(const rrs::CartPos& pose) {
    if (!pose.matrix().allFinite())
        return tl::unexpected<std::string>("The pose contains a value that is not finite.");
    if (pose.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
        return tl::unexpected<std::string>("The last row of the pose's matrix is not 0 0 0 1.");
    }
    const Eigen::Matrix3d r = pose.linear();
    if (!(r * r.transpose()).isIdentity(kRotationTolerance) || r.determinant() < 0) {
        return tl::unexpected<std::string>(
            "The upper left 3x3 part of the pose is not a rotation: its columns must be orthogonal unit "
            "vectors, "
            "right-handed.");
    }
    return {};
}

}  // namespace gsim::kinematics
