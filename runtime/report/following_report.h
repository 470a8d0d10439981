#pragma once

#include <optional>
#include <vector>

#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Following error of an axis: mm for a linear axis, deg for a rotary one, set point minus position.
struct AxisFollowing {
    char letter = 'X';
    bool rotary = false;
    double gain_1_s = 0;              ///< Position loop gain; infinite: it follows at once.
    double constant_speed_lag_s = 0;  ///< By which it is late at a constant speed.
    double peak = 0;                  ///< Largest, in either direction.
    double peak_t_s = 0;
    SourceLocation peak_location = {};
    double rms = 0;  ///< Root mean square over the full run, standstill included.
    double end = 0;  ///< At the end of the run.
};

/// Max distance of the real TCP from the path of its set points, on the part.
struct ContourError {
    double error_mm = 0;
    double t_s = 0;
    SourceLocation location = {};  ///< Location of the current move.
};

/// Real positions of axes and TCP in a run (docs/servo.md).
struct FollowingReport {
    std::vector<AxisFollowing> axes;
    ContourError feed = {};   ///< During feed moves and dwells,
    ContourError rapid = {};  ///< and rapid moves.
    /// The same as `feed`, but from the programmed path; a controller module does not report it.
    std::optional<ContourError> program = ContourError{};
    double band_mm = 0;   ///< In which an axis is in position,
    double band_deg = 0;  ///< and a rotary one.
    /// Time after the end of the run at which all axes are in their bands to stay; nullopt: they are not
    /// within 20 time constants of the slowest.
    std::optional<double> in_position_s = 0;
};

}  // namespace gsim::simulation
