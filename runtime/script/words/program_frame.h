#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <utility>

#include "runtime/simulator/commands.h"

namespace gsim::script {

/// Map between program coordinates (in mm and deg, absolute) and machine coordinates. Per axis machine =
/// program + offset. If a matrix is set (rotation, scaling, mirror image), X, Y and Z are machine = matrix *
/// program + offset.
class ProgramFrame {
  public:
    /// Makes the identity. `xyz_axes`: index of the machine's X, Y and Z axis, -1 if it does not have one.
    ProgramFrame(std::size_t axis_count, const std::array<int, 3>& xyz_axes);

    double offset(int axis) const { return offset_[axis]; }
    /// Returns true if the offset changes.
    bool set_offset(int axis, double value) { return std::exchange(offset_[axis], value) != value; }
    /// Returns false if the matrix cannot be inverted; it is not set then.
    bool set_matrix(const std::optional<Eigen::Matrix3d>& matrix);
    bool has_matrix() const { return matrix_.has_value(); }

    /// Maps a vector of X, Y and Z, without the offset.
    Eigen::Vector3d direction(const Eigen::Vector3d& program) const;
    simulation::AxisVector to_machine(simulation::AxisVector program) const;
    simulation::AxisVector to_program(simulation::AxisVector machine) const;

  private:
    Eigen::Vector3d xyz(const simulation::AxisVector& values) const;
    void set_xyz(simulation::AxisVector& values, const Eigen::Vector3d& point) const;

    std::array<int, 3> xyz_axes_;
    simulation::AxisVector offset_;
    std::optional<Eigen::Matrix3d> matrix_;
    Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Identity();
};

}  // namespace gsim::script
