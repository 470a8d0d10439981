#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
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

/// The part that an axis moves: the tool, the work under it, or neither, such as a filament feed.
enum class CarriedPart { tool, work, none };

constexpr std::string_view name(CarriedPart carries) {
    constexpr std::array<std::string_view, 3> kNames{"tool", "work", "nothing"};
    return kNames[static_cast<std::size_t>(carries)];
}

/// Treatment of programmed angles by a rotary axis; see docs/machine-file.md.
enum class RotaryMode {
    limited,   ///< Full turns count: 370 is not 10.
    shortest,  ///< An angle is reached in the shorter direction.
    unwind,    ///< Full turns are made, but then subtracted from the reading.
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

inline constexpr int kHomeCount = 4;  ///< Home positions of a machine: the primary one and three others.

/// One axis of the machine: the letter that programs use and the joint it drives. The index of an axis is the
/// index of its joint. Axes that carry the tool are in the order from the world to the tool. Those that carry
/// the work are in the order from the world to the work. Units are mm or deg, by kind.
struct Axis {
    char letter = 'X';
    AxisKind kind = AxisKind::linear;
    double min = 0;
    double max = 0;
    double max_speed = std::numeric_limits<double>::infinity();         ///< mm/s or deg/s
    double max_acceleration = std::numeric_limits<double>::infinity();  ///< mm/s2 or deg/s2
    std::optional<double> max_deceleration = std::nullopt;  ///< mm/s2 or deg/s2; none: as max_acceleration.
    double max_jerk = std::numeric_limits<double>::infinity();  ///< mm/s3 or deg/s3
    /// Jump of speed that the axis can take at a corner, mm/s or deg/s.
    double max_speed_step = std::numeric_limits<double>::infinity();
    double step = 0;  ///< Smallest step of the axis, mm or deg; 0: none.
    double home = 0;
    double zero = 0;  ///< Reading of the axis at the joint's zero.
    DhRow dh = {};
    /// From the joint before to this one, whose motion is along or about its Z unless `direction` gives
    /// another one. If both are given, `dh` follows the motion.
    std::optional<Frame> frame = std::nullopt;
    /// Alternative to `dh`: the direction in which the tool moves, or turns, relative to the work as the
    /// value grows. It is in the axes of the frame of the joint before (with `frame` applied, if given).
    std::optional<AxisDirection> direction = std::nullopt;
    CarriedPart carries = CarriedPart::tool;
    RotaryMode turning = RotaryMode::limited;
    /// Home positions 2 to 4, if the axis has a value there.
    std::array<std::optional<double>, kHomeCount - 1> other_homes = {};
    Drive drive = {};
    /// Servo loop, if given in the file: following errors of all axes are computed then.
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

/// All data that do not change during a run. Read from a machine file; see docs/machine-file.md.
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
    std::optional<Process> process = std::nullopt;  ///< If given in the file.
    WordTimes times = {};
    std::vector<LinkShape> shapes = {};  ///< Bodies of the machine; their names differ.
    /// Pairs of shapes, as indices, that may touch each other.
    std::vector<std::pair<std::size_t, std::size_t>> ignored = {};
    std::vector<AxisGroup> groups = {};                     ///< Their names differ.
    std::optional<DynamicsTable> dynamics = std::nullopt;   ///< If forces and torques are computed.
    std::optional<Calibration> calibration = std::nullopt;  ///< If parameters were fitted to recorded runs.

    /// Returns the index of the axis with this (upper case) letter.
    std::optional<std::size_t> find(char letter) const;

    bool operator==(const Machine&) const = default;
};

/// Returns the value of an axis (mm or deg, as programs give it) for a joint value (mm or rad).
double axis_value(const Axis& axis, double joint_value);
/// Returns the joint value (mm or rad) for a value of the axis (mm or deg).
double joint_value(const Axis& axis, double axis_value);
/// Returns the joint values with all axes at home.
rrs::JointPos home_position(const Machine& machine);

/// Returns an error if the machine's chain does not fit its inverse.
std::optional<Error> find_kinematic_error(const Machine& machine);

/// Returns an error if the machine or its planner cannot turn the tool as its controller's rules require. For
/// a machine without a kinematic error.
std::optional<Error> find_controller_error(const Machine& machine);

/// Returns the target (mm or deg) of an axis at `now` that is commanded to `value`. For a rotary axis it may
/// differ by full turns, according to its `turning`. `origin` is the zero of both values, in machine
/// coordinates, in which the axis has its range.
double rotary_target(const Axis& axis, double value, double now, double origin);

/// Returns the reading of an axis that a program gets at `value` in machine coordinates; without the full
/// turns for an axis that unwinds.
double reading(const Axis& axis, double value);

/// Returns the kinematics that the machine's joints and inverse describe. Throws std::invalid_argument if
/// find_kinematic_error() finds an error; read_machine() accepts no such machine.
std::shared_ptr<const kinematics::Kinematics> make_kinematics(const Machine& machine);

}  // namespace gsim::machine
