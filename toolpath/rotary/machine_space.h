#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "machine/model/machine.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Axis values as programs give them, mm or deg: of all axes, or of the rotary ones in their order.
using AxisValues = rrs::JointPos;

/// Machine as a path sees it: three linear axes X, Y and Z position the TCP, rotary axes turn the tool.
class MachineSpace {
  public:
    /// Makes it; `machine` must outlive this.
    static Result<MachineSpace> make(const machine::Machine& machine);

    const machine::Machine& machine() const { return *machine_; }
    std::size_t rotary_count() const { return rotary_.size(); }
    const machine::Axis& rotary_axis(std::size_t i) const { return machine_->axes[rotary_[i]]; }
    AxisValues home_rotary() const;
    AxisValues home() const;

    /// Returns true if turning a rotary axis moves the linear ones while the TCP stays.
    bool is_coupled() const { return is_coupled_; }
    /// Returns all axis values with the TCP at `tcp_mm` and these rotary values.
    AxisValues axes(const Eigen::Vector3d& tcp_mm, const AxisValues& rotary) const;
    /// Returns the TCP at these values, in the work frame.
    Eigen::Vector3d tcp(const AxisValues& axes) const;
    /// Returns joint values, mm or rad.
    rrs::JointPos joints(const AxisValues& axes) const;
    /// Returns the upward direction of the tool axis, a unit vector.
    Eigen::Vector3d tool_axis(const AxisValues& axes) const;
    /// Returns their X, Y and Z.
    Eigen::Vector3d linear(const AxisValues& axes) const;

    /// Returns rotary values for a tool axis or a full orientation with the TCP there. These are the results
    /// of the inverse kinematics near `near` and near its mirror images (turning axis half a turn further,
    /// tilt in the other direction). Full turns are as they come.
    Result<std::vector<AxisValues>> solve_rotary(const Vector& tcp_mm, const Orientation& orientation,
                                                 const AxisValues& near) const;

    /// Returns an error if an axis is out of its range.
    std::optional<Error> find_axis_range_error(const AxisValues& axes) const;
    /// Returns the same for values that are counted from another origin of X, Y and Z; without it those of X,
    /// Y and Z are not checked.
    std::optional<Error> find_axis_range_error(AxisValues axes, const std::optional<Vector>& origin_mm) const;
    /// Returns the same for machine coordinates of some axes, by letter.
    std::optional<Error> find_axis_range_error(const std::map<char, double>& axes) const;
    /// Returns the end of Z above the work; nullopt if it has none.
    std::optional<double> max_z_mm() const;

  private:
    explicit MachineSpace(const machine::Machine& machine) : machine_(&machine) {}
    rrs::CartPos tool_pose(const Eigen::Vector3d& tcp_mm, const Orientation& orientation,
                           const rrs::JointPos& from) const;
    AxisValues with_rotary(const AxisValues& rotary) const;
    void analyze();

    const machine::Machine* machine_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::array<std::size_t, 3> linear_{};
    std::vector<std::size_t> rotary_;
    bool is_coupled_ = true;
    Eigen::Vector3d tcp_at_zero_ = Eigen::Vector3d::Zero();    // with the linear axes at 0
    Eigen::Matrix3d to_linear_ = Eigen::Matrix3d::Identity();  // from TCP travel to X, Y and Z
};

}  // namespace gsim::path
