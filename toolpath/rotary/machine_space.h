#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "machine/model/machine.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Values of axes as programs give them, mm or deg: of all axes, or of the rotary ones in their order.
using AxisValues = rrs::JointPos;

/// A machine as a path sees it: three linear axes X, Y and Z place the tip, rotary axes turn the tool.
class MachineSpace {
  public:
    /// `machine` must outlive this. The error is a sentence.
    static tl::expected<MachineSpace, std::string> make(const machine::Machine& machine);

    const machine::Machine& machine() const { return *machine_; }
    std::size_t rotary_count() const { return rotary_.size(); }
    const machine::Axis& rotary_axis(std::size_t i) const { return machine_->axes[rotary_[i]]; }
    AxisValues home_rotary() const;
    AxisValues home() const;

    /// Whether turning a rotary axis moves the linear ones while the tip stays where it is.
    bool coupled() const { return coupled_; }
    /// All axes with the tip at `tip_mm` and the rotary axes at these values.
    AxisValues axes(const Eigen::Vector3d& tip_mm, const AxisValues& rotary) const;
    /// Where the tip of the tool is then, in the work frame.
    Eigen::Vector3d tip(const AxisValues& axes) const;
    /// Joint values, mm or rad.
    rrs::JointPos joints(const AxisValues& axes) const;
    /// Where the tool points up to, a unit vector.
    Eigen::Vector3d tool_axis(const AxisValues& axes) const;
    /// X, Y and Z of them.
    Eigen::Vector3d linear(const AxisValues& axes) const;

    /// Rotary values for a tool axis or a whole orientation with the tip there: what the inverse kinematics
    /// give near `near` and near its mirror images (the turning axis half a turn further, the tilt the other
    /// way). Whole turns are as they come. The error is a sentence.
    tl::expected<std::vector<AxisValues>, std::string> rotary_for(const Vector& tip_mm,
                                                                  const Orientation& orientation,
                                                                  const AxisValues& near) const;

    /// Which axis is out of its range, as a sentence; empty if none is.
    std::string range_fault(const AxisValues& axes) const;
    /// The same where the values are counted from another place of X, Y and Z; without it those of X, Y and Z
    /// are not looked at.
    std::string range_fault(AxisValues axes, const std::optional<Vector>& origin_mm) const;
    /// The same of machine coordinates of some axes, by letter.
    std::string range_fault(const std::map<char, double>& axes) const;
    /// The end of Z above the work; none where it has none.
    std::optional<double> top_mm() const;

  private:
    explicit MachineSpace(const machine::Machine& machine) : machine_(&machine) {}
    rrs::CartPos pose_for(const Eigen::Vector3d& tip_mm, const Orientation& orientation,
                          const rrs::JointPos& from) const;
    AxisValues with_rotary(const AxisValues& rotary) const;
    void study();

    const machine::Machine* machine_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::array<std::size_t, 3> linear_{};
    std::vector<std::size_t> rotary_;
    bool coupled_ = true;
    Eigen::Vector3d tip_at_zero_ = Eigen::Vector3d::Zero();    // with the linear axes at 0
    Eigen::Matrix3d to_linear_ = Eigen::Matrix3d::Identity();  // from the tip's way to X, Y and Z
};

}  // namespace gsim::path
