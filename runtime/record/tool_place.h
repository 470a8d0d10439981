#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>

#include "machine/model/machine.h"
#include "runtime/simulator/commands.h"
#include "toolpath/model/path.h"

namespace gsim::record {

/// Where a machine's tool is, as paths tell it, for values of its axes (mm or deg).
class ToolPlace {
  public:
    /// `machine` must outlive this, and its kinematics be without fault.
    explicit ToolPlace(const machine::Machine& machine);

    /// The tip in the work frame, mm.
    Eigen::Vector3d tip(const simulation::AxisVector& axes) const;
    /// The same as paths hold it: to 1e-9 mm, so that what is gone through again comes out equal.
    path::Vector position(const simulation::AxisVector& axes) const;
    /// The rotary axes by letter; roll, pitch and yaw where no linear X, Y and Z carry the tool; nothing
    /// where nothing turns.
    std::optional<path::Orientation> orientation(const simulation::AxisVector& axes) const;

    /// Whether X, Y and Z are linear axes of the machine.
    bool has_xyz() const { return has_xyz_; }
    /// The index of X, Y or Z (0, 1, 2) among the axes; -1 where there is none.
    Eigen::Index axis(Eigen::Index direction) const { return xyz_[static_cast<std::size_t>(direction)]; }
    /// X, Y and Z of axis values; 0 where there is no such axis.
    Eigen::Vector3d xyz(const simulation::AxisVector& axes) const;
    /// Whether the tip goes with X, Y and Z alone from one place to the other: no other axis moves.
    bool is_xyz_alone(const simulation::AxisVector& from, const simulation::AxisVector& to) const;
    /// Whether other linear axes move from one place to the other.
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

/// A number to 1e-9, without noise of its last bits.
double rounded(double value);
/// A vector or direction as paths hold it.
path::Vector to_path(const Eigen::Vector3d& vector);

}  // namespace gsim::record
