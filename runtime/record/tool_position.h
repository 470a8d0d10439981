#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>

#include "machine/model/machine.h"
#include "runtime/simulator/commands.h"
#include "toolpath/model/path.h"

namespace gsim::record {

/// Position of a machine's tool, as paths describe it, for values of its axes (mm or deg).
class ToolPosition {
  public:
    /// `machine` must outlive this, and its kinematics be without error.
    explicit ToolPosition(const machine::Machine& machine);

    /// Returns the TCP in the work frame, mm.
    Eigen::Vector3d tcp(const simulation::AxisVector& axes) const;
    /// Returns the same as paths store it: to 1e-9 mm, so that a repeated run gives equal values.
    path::Vector position(const simulation::AxisVector& axes) const;
    /// Returns the rotary axes by letter; roll, pitch and yaw if no linear X, Y and Z carry the tool; nullopt
    /// if no axis turns.
    std::optional<path::Orientation> orientation(const simulation::AxisVector& axes) const;

    /// Returns true if X, Y and Z are linear axes of the machine.
    bool has_xyz() const { return has_xyz_; }
    /// Returns the index of X, Y or Z (0, 1, 2) among the axes; -1 if it is missing.
    Eigen::Index axis(Eigen::Index direction) const { return xyz_[static_cast<std::size_t>(direction)]; }
    /// Returns X, Y and Z of axis values; 0 for a missing axis.
    Eigen::Vector3d xyz(const simulation::AxisVector& axes) const;
    /// Returns true if the TCP moves with X, Y and Z only from one position to the other: no other axis
    /// moves.
    bool only_xyz_moves(const simulation::AxisVector& from, const simulation::AxisVector& to) const;
    /// Returns true if other linear axes move from one position to the other.
    bool moves_other_linear_axes(const simulation::AxisVector& from, const simulation::AxisVector& to) const;

  private:
    bool is_xyz(Eigen::Index axis) const;
    rrs::CartPos pose(const simulation::AxisVector& axes) const;

    const machine::Machine& machine_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::array<Eigen::Index, 3> xyz_{-1, -1, -1};
    bool has_xyz_ = false;
    bool has_rotary_ = false;
};

/// Rounds a number to 1e-9, without noise of its last bits.
double rounded(double value);
/// Converts a vector or direction to the form of paths.
path::Vector to_path(const Eigen::Vector3d& vector);

}  // namespace gsim::record
