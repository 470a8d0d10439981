#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "machine/model/machine.h"
#include "motion/planner/move.h"
#include "motion/planner/planner_setup.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/tcp_frame.h"

namespace gsim::simulation {

/// Position that the program has reached, and the relation of the program's coordinates to the joints. The
/// coordinates are the values of the axes or, under TCP control, with X, Y and Z of the TCP.
class ProgramPosition {
  public:
    /// Begins at the machine's home. Both arguments must outlive this.
    ProgramPosition(const machine::Machine& machine, const motion::PlannerSetup& setup);

    /// Returns the coordinates at the end of the last move, mm or deg.
    const AxisVector& axes() const { return axes_; }
    void set(const AxisVector& axes) { axes_ = axes; }
    /// Sets the coordinates that belong to these joints (mm or rad).
    void set_joints(const rrs::JointPos& joints) { axes_ = at(joints); }

    /// Returns the frame of the coordinates under TCP control; no value without it.
    const std::optional<TcpFrame>& tcp_frame() const { return tcp_frame_; }
    void set_tcp_frame(const std::optional<TcpFrame>& frame) { tcp_frame_ = frame; }

    /// Returns the joints (mm or rad) of a target of the program; the error is a message.
    tl::expected<rrs::JointPos, std::string> solve_joints(const AxisVector& target) const;
    /// Returns the coordinates that belong to joints, mm or deg.
    AxisVector at(const rrs::JointPos& joints) const;
    /// Returns the circle of an arc of the program, in the coordinates of the planner.
    motion::Circle circle(const ArcMove& move) const;

    /// Returns the joints of axis values, without TCP control.
    rrs::JointPos to_joints(const AxisVector& axes) const;
    /// Returns the axis values of joints, without TCP control.
    AxisVector to_axes(const rrs::JointPos& joints) const;
    /// Returns X, Y and Z of axis values in mm; 0 for an axis that the machine does not have.
    Eigen::Vector3d space_point(const AxisVector& axes) const;
    /// Returns true if only rotary axes move to a target.
    bool is_rotary_only(const AxisVector& target) const;

  private:
    const machine::Machine& machine_;
    const motion::PlannerSetup& setup_;
    std::array<int, 3> xyz_axes_;  ///< Index of X, Y and Z; -1 if the machine has no such axis.
    std::optional<TcpFrame> tcp_frame_;
    AxisVector axes_;
};

}  // namespace gsim::simulation
