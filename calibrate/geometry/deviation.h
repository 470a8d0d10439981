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

/// One way in which a machine's geometry may differ from its file; 0 is as the file has it.
struct Deviation {
    enum class Of {
        zero,        ///< Of an axis: its reading at the joint's zero.
        scale,       ///< Of a linear axis: it goes farther than it reads.
        shift,       ///< Of a rotary axis: its line lies beside where the file has it.
        tilt,        ///< Of an axis: its line is turned.
        base,        ///< All joints that carry the tool lie beside or are turned.
        tool,        ///< The tool centre point, in its own axes.
        work,        ///< The work frame, in its own axes.
        instrument,  ///< The frame in which tips are measured, in the axes of the work frame.
    };

    std::string name;  ///< "C shift_x_mm", "base turn_z_deg"
    Of of = Of::zero;
    DeviationUnit unit = DeviationUnit::mm;
    std::size_t axis = 0;
    /// Along which, or about which. Shifts, tilts and those of the base count in the world's axes, with all
    /// joints at zero.
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();

    bool is_turn() const { return unit == DeviationUnit::deg; }
};

/// What a file may well be off by, in the deviation's unit: beyond it measurements say nothing that was not
/// known before.
double usual_size(const Deviation& deviation);

/// What is looked for in a machine.
struct DeviationChoice {
    bool own_frame = false;         ///< Tips are in the frame of the instrument, wherever that stands.
    std::vector<std::string> held;  ///< Names, or words of them, of what is not looked for: "scale", "tool".
};

/// All deviations of a machine, many of which cannot be told from others: those before others in the list are
/// what people would rather say it by. A frame that no joint carries, and axes that carry nothing, have none.
std::vector<Deviation> all_deviations(const machine::Machine& machine, const DeviationChoice& choice);

/// The first of the held words that is in no name, so that nothing is held by it.
std::optional<std::string> unknown_held(const machine::Machine& machine, const DeviationChoice& choice);

/// A machine, and what its file cannot say: scales and the frame of the instrument.
struct Geometry {
    machine::Machine machine;
    std::vector<double> scales;  ///< Of each axis: mm that it goes for each mm that it reads, or 1.
    rrs::CartPos instrument = rrs::CartPos::Identity();  ///< The work frame in that of the instrument.
};

/// A geometry with any deviations. Immutable.
class DeviatedMachine {
  public:
    explicit DeviatedMachine(Geometry nominal);

    const Geometry& nominal() const { return nominal_; }
    /// Values in the deviations' units. Each axis's line is moved by itself: with all joints at zero, joints
    /// behind it and the tool stay where they are. In the file it goes into the axis's `frame`, and its
    /// inverse into what follows on the same side.
    Geometry at(std::span<const Deviation> deviations, const Eigen::VectorXd& values) const;
    /// The geometry with the tool turned about its tip so that with all joints at zero it stands against the
    /// work as in the nominal one: for tips that tell nothing of that.
    Geometry with_nominal_turn(Geometry geometry) const;

  private:
    Geometry nominal_;
    std::vector<rrs::CartPos> joints_;  ///< Frames of the joints in the world, with all at zero.
    std::vector<rrs::CartPos> behind_;  ///< What is fixed behind each joint.
};

/// Works out where tips are.
class TipFinder {
  public:
    explicit TipFinder(const Geometry& geometry);
    /// The tool centre point as the instrument sees it, for readings of the axes in mm and deg.
    rrs::CartPos tip(std::span<const double> readings) const;

  private:
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::vector<machine::Axis> axes_;
    std::vector<double> scales_;
    rrs::CartPos instrument_;
};

}  // namespace gsim::calibrate
