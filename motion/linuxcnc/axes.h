#pragma once

#include <Eigen/Core>
#include <array>

#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// X, Y and Z among the joints: the axes in which corners are judged. An absent axis is at 0 and has no
/// limits.
class Axes {
  public:
    explicit Axes(const PlannerSetup& setup);

    const Eigen::Vector3d& max_speed_mm_s() const { return max_speed_mm_s_; }
    const Eigen::Vector3d& max_acceleration_mm_s2() const { return max_acceleration_mm_s2_; }
    const Eigen::Vector3d& max_jerk_mm_s3() const { return max_jerk_mm_s3_; }

    Eigen::Vector3d point(const rrs::JointPos& joints) const;
    void set_point(const Eigen::Vector3d& point, rrs::JointPos& joints) const;

    /// Returns the largest magnitude in the plane across `normal` of a quantity for which each axis has its
    /// value in `limits`.
    static double in_plane(const Eigen::Vector3d& limits, const Eigen::Vector3d& normal);

  private:
    std::array<int, 3> joints_;
    Eigen::Vector3d max_speed_mm_s_;
    Eigen::Vector3d max_acceleration_mm_s2_;
    Eigen::Vector3d max_jerk_mm_s3_;
};

}  // namespace gsim::motion::linuxcnc
