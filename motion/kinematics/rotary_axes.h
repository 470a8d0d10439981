#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace gsim::kinematics {

/// Orientation of a tool that at most two rotary axes carry, which are not parallel: Rot(first) Rot(second)
/// at_zero. This is Paden and Kahan's second subproblem for two axes (Murray, Li, Sastry 1994, section
/// 3.3.2), and their first for one axis.
class RotaryAxes {
  public:
    using Angles = Eigen::Vector2d;  ///< Angles of the first and the second axis, rad; 0 if absent.

    struct RotarySolution {
        Angles angles;
        bool exact = true;  ///< True if the full rotation is reached, not only the tool axis.
    };

    /// `axes` are unit vectors, at most two and not parallel.
    RotaryAxes(std::vector<Eigen::Vector3d> axes, const Eigen::Matrix3d& at_zero);

    int count() const { return static_cast<int>(axes_.size()); }
    Eigen::Matrix3d rotated(const Angles& angles) const;
    /// Returns the rotation about the first axis (0) or the second (1).
    Eigen::Matrix3d turn(int axis, double angle_rad) const;

    /// Returns angles that bring the tool into `rotation`. Two axes reach two of three degrees of
    /// orientation. A rotation that they reach (to 1e-6) is reached exactly. Further solutions, or otherwise
    /// all of them, match the tool axis (Z), to 1e-6. An angle without influence on that has its value in
    /// `near`. An empty result means that the tool axis is out of reach.
    std::vector<RotarySolution> choices(const Eigen::Matrix3d& rotation, const Angles& near) const;

    /// Returns a message that explains why no solution exists.
    std::string out_of_reach_message(const Eigen::Vector3d& tool_axis) const;

  private:
    Angles solve_rotation(const Eigen::Matrix3d& turn) const;
    std::vector<Angles> solve_tool_axis(const Eigen::Vector3d& tool_axis, const Angles& near) const;
    std::vector<Angles> solve_two_axes(const Eigen::Vector3d& tool_axis, const Angles& near) const;
    double orientation_error_rad(const Eigen::Vector3d& tool_axis) const;

    std::vector<Eigen::Vector3d> axes_;
    Eigen::Matrix3d at_zero_;
};

}  // namespace gsim::kinematics
