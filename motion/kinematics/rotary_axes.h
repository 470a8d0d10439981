#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace gsim::kinematics {

/// The orientation of a tool behind at most two rotary axes that are not parallel:
/// Rot(first) Rot(second) at_zero. For two axes this is Paden and Kahan's second subproblem (Murray, Li,
/// Sastry 1994, section 3.3.2), for one their first.
class RotaryAxes {
  public:
    using Angles = Eigen::Vector2d;  ///< Of the first and the second axis, rad; 0 where there is none.

    struct Choice {
        Angles angles;
        bool exact = true;  ///< The whole rotation is reached, not the tool's axis alone.
    };

    /// `axes` are unit vectors, at most two and not parallel.
    RotaryAxes(std::vector<Eigen::Vector3d> axes, const Eigen::Matrix3d& at_zero);

    int count() const { return static_cast<int>(axes_.size()); }
    Eigen::Matrix3d turned(const Angles& angles) const;
    /// Rotation about the first axis (0) or the second (1).
    Eigen::Matrix3d turn(int axis, double angle_rad) const;

    /// Angles that bring the tool into `rotation`. Two axes reach two of three degrees of orientation: a
    /// rotation that they reach (to 1e-6) is reached exactly; else, and besides, the tool's axis (Z) is
    /// matched, to 1e-6. An angle that makes no difference to that has its value in `near`. Without a choice
    /// the tool's axis is out of reach.
    std::vector<Choice> choices(const Eigen::Matrix3d& rotation, const Angles& near) const;

    /// Why there is no choice, as a sentence.
    std::string out_of_reach(const Eigen::Vector3d& tool_axis) const;

  private:
    Angles exact_angles(const Eigen::Matrix3d& turn) const;
    std::vector<Angles> tool_axis_angles(const Eigen::Vector3d& tool_axis, const Angles& near) const;
    std::vector<Angles> two_axis_angles(const Eigen::Vector3d& tool_axis, const Angles& near) const;
    double miss_rad(const Eigen::Vector3d& tool_axis) const;

    std::vector<Eigen::Vector3d> axes_;
    Eigen::Matrix3d at_zero_;
};

}  // namespace gsim::kinematics
