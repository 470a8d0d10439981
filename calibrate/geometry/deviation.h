#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::calibrate {

enum class DeviationUnit { mm, deg, ppm };

/// One possible difference between a machine's geometry and its file; 0 is as the file has it.
struct Deviation {
    enum class Kind {
        zero,        ///< For an axis: its reading at the joint's zero.
        scale,       ///< For a linear axis: it moves farther than it reads.
        shift,       ///< For a rotary axis: its line is offset from that in the file.
        tilt,        ///< For an axis: its line is rotated.
        base,        ///< All joints that carry the tool are offset or rotated.
        tool,        ///< The tool centre point, in tool axes.
        work,        ///< The work frame, in its axes.
        instrument,  ///< Frame of the TCP measurements, in the axes of the work frame.
    };

    std::string name;  ///< "C shift_x_mm", "base turn_z_deg"
    Kind kind = Kind::zero;
    DeviationUnit unit = DeviationUnit::mm;
    std::size_t axis = 0;
    /// Direction of the shift or axis of the rotation. Shifts, tilts and those of the base count in world
    /// axes, with all joints at zero.
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();

    bool is_rotation_error() const { return unit == DeviationUnit::deg; }
};

/// Returns the plausible error of a file, in the deviation's unit: beyond it measurements add no information.
double typical_size(const Deviation& deviation);

/// Selection of deviations to fit in a machine.
struct DeviationOptions {
    bool instrument_frame = false;   ///< TCP poses are in the instrument's frame, at any pose.
    std::vector<std::string> fixed;  ///< Names, or words of them, of what is not looked for: "scale", "tool".
};

/// Returns all deviations of a machine, many of which cannot be distinguished from others. The list begins
/// with those that users prefer. A frame that no joint carries, and axes that carry no other part, have none.
std::vector<Deviation> all_deviations(const machine::Machine& machine,
                                      const DeviationOptions& deviation_options);

/// Returns the first fixed word that occurs in no name, so that it fixes no deviation.
std::optional<std::string> find_unknown_fixed(const machine::Machine& machine,
                                              const DeviationOptions& deviation_options);

/// Machine with values that its file cannot contain: scales and the frame of the instrument.
struct Geometry {
    machine::Machine machine;
    std::vector<double> scales;  ///< For each axis: mm of motion for each mm that it reads, or 1.
    rrs::CartPos instrument = rrs::CartPos::Identity();  ///< The work frame in that of the instrument.
};

/// Geometry with any deviations. Immutable.
class DeviatedMachine {
  public:
    explicit DeviatedMachine(Geometry nominal);

    const Geometry& nominal() const { return nominal_; }
    /// Returns the geometry for values in the deviations' units. Each axis's line is moved independently:
    /// with all joints at zero, the following joints and the tool stay in position. In the file the motion is
    /// added to the axis's `frame`, and its inverse to the next element on the same side.
    Geometry at(std::span<const Deviation> deviations, const Eigen::VectorXd& values) const;
    /// Returns the geometry with the tool rotated about its TCP, so that with all joints at zero its
    /// orientation to the work is nominal. This is for measurements without that information.
    Geometry with_nominal_orientation(Geometry geometry) const;

  private:
    Geometry nominal_;
    std::vector<rrs::CartPos> joints_;        ///< Frames of the joints in the world, with all at zero.
    std::vector<rrs::CartPos> after_joints_;  ///< Fixed transform that follows each joint.
};

/// Calculator of TCP poses.
class TcpCalculator {
  public:
    explicit TcpCalculator(const Geometry& geometry);
    /// Returns the tool centre point in the instrument's frame, for readings of the axes in mm and deg.
    rrs::CartPos tcp(std::span<const double> readings) const;

  private:
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::vector<machine::Axis> axes_;
    std::vector<double> scales_;
    rrs::CartPos instrument_;
};

}  // namespace gsim::calibrate
