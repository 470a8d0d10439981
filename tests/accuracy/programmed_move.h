#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "machine/model/machine.h"

namespace gsim::accuracy {

/// A move as a program asks for it, or a dwell, with what the axes of its machine allow.
struct ProgrammedMove {
    double wait_s = 0;  ///< Of a dwell, which has none of the rest.
    bool rapid = false;
    double length_mm = 0;     ///< Of X, Y, Z along the way; 0 where others alone move.
    double length = 0;        ///< What its feed counts along: length_mm, or degrees.
    double all_axes = 0;      ///< Norm of the ways of all axes, a degree as a mm.
    double feed_s = 0;        ///< Programmed speed, mm/s or deg/s; of no meaning in a rapid.
    double most_speed = 0;    ///< That all axes allow along the way, as feed_s.
    double acceleration = 0;  ///< The same of accelerations.
    double radius_mm = 0;     ///< Of an arc, else 0, as what follows.
    double sweep_rad = 0;
    double climb_mm = 0;  ///< Along its axis.
    double sense = 1;     ///< -1: clockwise, seen against its axis.
    Eigen::Vector3d normal{0, 0, 1};
    double extruded = 0;              ///< What an axis E makes, mm for each mm of the way.
    Eigen::Vector3d enters{0, 0, 0};  ///< Unit vectors along X, Y, Z at its start
    Eigen::Vector3d leaves{0, 0, 0};  ///< and at its end; 0 where they do not move.
};

/// What a program asks of its machine.
struct ProgrammedRun {
    std::vector<ProgrammedMove> moves;
    machine::Machine machine;
};

/// The moves in what `gsim-run --moves` writes of a run from rest to rest, so that their ends are those of
/// the program. The error says which line cannot be understood.
tl::expected<std::vector<ProgrammedMove>, std::string> read_programmed_moves(std::istream& moves,
                                                                             const machine::Machine& machine);

}  // namespace gsim::accuracy
