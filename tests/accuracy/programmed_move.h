#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "machine/model/machine.h"

namespace gsim::accuracy {

/// Move as a program asks for it, or a dwell, with the limits of the machine's axes.
struct ProgrammedMove {
    double wait_s = 0;  ///< Time of a dwell, which has no other values.
    bool rapid = false;
    double length_mm = 0;     ///< Path of X, Y, Z; 0 if only others move.
    double length = 0;        ///< Length that its feed refers to: length_mm, or degrees.
    double all_axes = 0;      ///< Norm of the distances of all axes, a degree as a mm.
    double feed_s = 0;        ///< Programmed speed, mm/s or deg/s; of no meaning in a rapid.
    double speed_limit = 0;   ///< Limit of all axes along the path, as feed_s.
    double acceleration = 0;  ///< The same of accelerations.
    double radius_mm = 0;     ///< Radius of an arc, else 0, as what follows.
    double sweep_rad = 0;
    double climb_mm = 0;  ///< Along its axis.
    double sense = 1;     ///< -1: clockwise, seen against its axis.
    Eigen::Vector3d normal{0, 0, 1};
    double extruded = 0;              ///< Distance of an axis E, mm for each mm of the path.
    Eigen::Vector3d enters{0, 0, 0};  ///< Unit vectors along X, Y, Z at its start
    Eigen::Vector3d leaves{0, 0, 0};  ///< and at its end; 0 if they do not move.
};

/// Moves that a program asks for, and its machine.
struct ProgrammedRun {
    std::vector<ProgrammedMove> moves;
    machine::Machine machine;
};

/// Returns the moves in the output of `gsim-run --moves` for a run from standstill to standstill, so that
/// their ends are those of the program. The error names the line that cannot be parsed.
Result<std::vector<ProgrammedMove>> read_programmed_moves(std::istream& moves,
                                                          const machine::Machine& machine);

}  // namespace gsim::accuracy
