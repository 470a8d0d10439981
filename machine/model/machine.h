#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/services/controller_rules.h"
#include "machine/model/axis_direction.h"
#include "machine/model/axis_group.h"
#include "machine/model/calibration.h"
#include "machine/model/dynamics_table.h"
#include "machine/model/frame.h"
#include "machine/model/link_shape.h"
#include "machine/model/process.h"
#include "machine/model/program_table.h"
#include "machine/model/servo_table.h"
#include "machine/model/word_times.h"
#include "motion/kinematics/kinematics.h"

namespace gsim::machine {

enum class AxisKind { linear, rotary };

/// What an axis moves: the tool, the work under it, or neither: what feeds filament.
enum class Carries { tool, work, nothing };

constexpr std::string_view name(Carries carries) {
    constexpr std::array<std::string_view, 3> kNames{"tool", "work", "nothing"};
    return kNames[static_cast<std::size_t>(carries)];
}

/// How a rotary axis takes the angles that programs give it; see docs/machine-file.md.
enum class Turning {
    limited,   ///< Whole turns count: 370 is not 10.
    shortest,  ///< An angle is reached the shorter way round.
    unwind,    ///< Whole turns are made, but taken off the reading once they are made.
};

/// One row of a Denavit-Hartenberg table (standard convention: Rz(theta) Tz(d) Tx(a) Rx(alpha)); the joint's
/// value is added to d (prismatic) or theta (revolute).
struct DhRow {
    double theta_deg = 0;
    double d_mm = 0;
    double a_mm = 0;
    double alpha_deg = 0;

    bool operator==(const DhRow&) const = default;
};

inline constexpr int kHomes = 4;  ///< Home positions of a machine: the primary one and three others.

/// One axis of the machine: the letter that programs use and the joint it drives. The index of an axis is the
/// index of its joint. Axes that carry the tool stand in the order from the world to the tool, those that
/// carry the work in the order from the world to the work. Units are mm or deg, by kind.
struct Axis {
    char letter = 'X';
    AxisKind kind = AxisKind::linear;
    double min = 0;
    double max = 0;
    double max_speed = std::numeric_limits<double>::infinity();         ///< mm/s or deg/s
    double max_acceleration = std::numeric_limits<double>::infinity();  ///< mm/s2 or deg/s2
    std::optional<double> max_deceleration = std::nullopt;  ///< mm/s2 or deg/s2; none: as max_acceleration.
    double max_jerk = std::numeric_limits<double>::infinity();  ///< mm/s3 or deg/s3
    /// Jump of speed that the axis stands at a corner, mm/s or deg/s.
    double max_speed_step = std::numeric_limits<double>::infinity();
    double step = 0;  ///< Smallest step of the axis, mm or deg; 0: none.
    double home = 0;
    double zero = 0;  ///< Reading of the axis at the joint's zero.
    DhRow dh = {};
    /// From the joint before to this one, whose motion is along or about its Z unless `direction` says
    /// another one. `dh` stands behind the motion where both are given.
    std::optional<Frame> frame = std::nullopt;
    /// In place of `dh`: how the tool goes, or turns, against the work as the value grows, in the axes of the
    /// frame of the joint before (behind `frame`, where there is one).
    std::optional<AxisDirection> direction = std::nullopt;
    Carries carries = Carries::tool;
    Turning turning = Turning::limited;
    /// Home positions 2 to 4, where the axis has a value there.
    std::array<std::optional<double>, kHomes - 1> other_homes = {};
    Drive drive = {};
    /// Where the file tells of one: following errors are worked out then, of all axes.
    std::optional<Servo> servo = std::nullopt;

    double deceleration() const { return max_deceleration.value_or(max_acceleration); }
    bool operator==(const Axis&) const = default;
};

/// Limits of the tool's path, whatever the axes could do.
struct PathLimits {
    double max_feed_mm_s = std::numeric_limits<double>::infinity();   ///< Contour speed cap of feed moves.
    double max_rapid_mm_s = std::numeric_limits<double>::infinity();  ///< Speed cap of rapid moves.
    double max_acceleration_mm_s2 = std::numeric_limits<double>::infinity();  ///< Along the path, feed moves.
    double max_rapid_acceleration_mm_s2 =
        std::numeric_limits<double>::infinity();                      ///< Along the path, rapid moves.
    double max_jerk_mm_s3 = std::numeric_limits<double>::infinity();  ///< Along the path, all moves.

    bool operator==(const PathLimits&) const = default;
};

using InverseKind = kinematics::InverseKind;

/// Everything that does not change during a run. Read from a machine file; see docs/machine-file.md.
struct Machine {
    std::string name;
    std::vector<Axis> axes;
    PathLimits path;
    Frame base;  ///< World to the first frame of the joints that carry the tool.
    Frame tool;  ///< Last joint's frame to the tool centre point.
    Frame work;  ///< Last joint that carries the work, or the world, to the work frame.
    InverseKind inverse = InverseKind::none;
    rrs::ControllerRules controller;
    ProgramTable program = {};
    std::optional<Process> process = std::nullopt;  ///< Where the file tells it.
    WordTimes times = {};
    std::vector<LinkShape> shapes = {};  ///< Its own bodies; their names differ.
    /// Pairs of shapes, as indices, that may touch each other.
    std::vector<std::pair<std::size_t, std::size_t>> ignored = {};
    std::vector<AxisGroup> groups = {};                     ///< Their names differ.
    std::optional<DynamicsTable> dynamics = std::nullopt;   ///< Where forces and torques are worked out.
    std::optional<Calibration> calibration = std::nullopt;  ///< Where figures were fitted to recorded runs.

    /// Index of the axis with this (upper case) letter.
    std::optional<std::size_t> find(char letter) const;

    bool operator==(const Machine&) const = default;
};

/// The value of an axis (mm or deg, as programs give it) for a joint value (mm or rad).
double axis_value(const Axis& axis, double joint_value);
/// The joint value (mm or rad) for a value of the axis (mm or deg).
double joint_value(const Axis& axis, double axis_value);
/// Joint values with all axes at home.
rrs::JointPos home_position(const Machine& machine);

/// Why the machine's chain does not fit its inverse, as a sentence; nothing if it does.
std::optional<std::string> find_kinematic_fault(const Machine& machine);

/// Why the machine or its planner cannot turn the tool as its controller's rules ask, as a sentence; nothing
/// if they can. For a machine without a kinematic fault.
std::optional<std::string> find_controller_fault(const Machine& machine);

/// Where an axis goes (mm or deg) that stands at `now` and is told to go to `value`: a rotary one perhaps
/// elsewhere by whole turns, as its `turning` says. `origin` is where both values count from, in machine
/// coordinates, in which the axis has its range.
double turned_target(const Axis& axis, double value, double now, double origin);

/// What an axis shows a program that stands at `value` in machine coordinates: without the whole turns, of
/// one that unwinds.
double reading(const Axis& axis, double value);

/// The kinematics that the machine's joints and inverse describe. Throws
/// std::invalid_argument where find_kinematic_fault() finds one; read_machine() lets no such machine pass.
std::shared_ptr<const kinematics::Kinematics> make_kinematics(const Machine& machine);

}  // namespace gsim::machine
